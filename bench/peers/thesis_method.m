% Computes steady states with the numerical method of the thesis (3.6.1, 6.3.1), to compare them with those of
% frictiongen.
%
%   octave --no-gui --quiet thesis_method.m MASSES CONTACT EXCITED ZETA R BETA [CYCLES [RELTOL [ABSTOL [INITIALSTEP]]]]
%
% The scene is given as in stepper.c. While the contact slides, ode45 runs until its velocity is zero. While it sticks,
% a single mass waits until fzero finds its release. With more masses ode45 continues with the contact's mass fixed,
% until the load exceeds the friction force. The run starts from rest and covers CYCLES cycles (200). The amplitude is
% the largest value that ode45 returned in the last cycle.
%
% The thesis states the tolerances as "absolute and relative ... 1e-6 and 1e-12 respectively". They are taken here in
% the order of Matlab's options: RelTol = 1e-6, AbsTol = 1e-12.
%
% Prints the columns of stepper.c.
1;
warning ("off", "integrate_adaptive:unexpected_termination");

function dx = slide (t, x, s, way)
  n = s.n;
  u = x(n+1:end);
  a = s.p * cos (t) - s.K * x(1:n) - s.C * u;
  a(s.j) -= way * s.beta / s.r2;
  dx = [u; a];
endfunction

function dx = held (t, x, s)
  dx = slide (t, x, s, 0);
  dx(s.n + s.j) = 0;
endfunction

function f = load_of (t, x, s)
  f = s.r2 * (s.p(s.j) * cos (t) - s.K(s.j,:) * x(1:s.n) - s.C(s.j,:) * x(s.n+1:end));
endfunction

function [value, terminal, direction] = stops (t, x, s, way)
  value = way * x(s.n + s.j);
  terminal = true;
  direction = -1;
endfunction

function [value, terminal, direction] = tears (t, x, s)
  value = abs (load_of (t, x, s)) - s.beta;
  terminal = true;
  direction = 1;
endfunction

% Release of a single mass: bracketed in steps of 1/100 cycle.
function t = release (t, x, s, last)
  f = @(t) abs (load_of (t, x, s)) - s.beta;
  while t < last
    next = min (t + pi/50, last);
    if f (next) > 0
      if f (t) < 0
        t = fzero (f, [t, next]);
      endif
      return
    endif
    t = next;
  endwhile
endfunction

numbers = cellfun (@str2double, argv ());
if numel (numbers) < 6
  error ("MASSES CONTACT EXCITED ZETA R BETA [CYCLES [RELTOL [ABSTOL [INITIALSTEP]]]]");
endif
cycles = 200; relative_tolerance = 1e-6; absolute_tolerance = 1e-12; first = [];
if numel (numbers) > 6, cycles = numbers(7); endif
if numel (numbers) > 7, relative_tolerance = numbers(8); endif
if numel (numbers) > 8, absolute_tolerance = numbers(9); endif
if numel (numbers) > 9, first = numbers(10); endif
[n, contact, excited, zeta, r, beta] = num2cell (numbers(1:6)){:};

% The time to load ode45 does not count.
[~, ~] = ode45 (@(t, x) -x, [0 1], 1, odeset ("Events", @(t, x) deal (x, true, 0)));
start = tic;
s.n = n; s.j = contact; s.beta = beta; s.r2 = r^2;
chain = 2 * eye (n) - diag (ones (n-1, 1), 1) - diag (ones (n-1, 1), -1);
chain(n,n) = 1;
[shapes, squares] = eig (chain);
s.K = chain / s.r2;
s.C = shapes * diag (2 * zeta * sqrt (diag (squares)) / r) * shapes';
base = excited == 0;
s.p = zeros (n, 1);
if base, s.p(:) = 1; else s.p(excited) = 1 / s.r2; endif

last = 2 * pi * cycles;
t = 0; x = zeros (2*n, 1);
force = load_of (t, x, s);
way = sign (force) * (abs (force) > beta);
relative = absolute = count = reversals = 0;
keep = odeset ("RelTol", relative_tolerance, "AbsTol", absolute_tolerance, "InitialStep", first);
while t < last
  was = way;
  if way
    [times, states] = ode45 (@(t, x) slide (t, x, s, way), [t, last], x, ...
                             odeset (keep, "Events", @(t, x) stops (t, x, s, way)));
  elseif n > 1
    [times, states] = ode45 (@(t, x) held (t, x, s), [t, last], x, ...
                             odeset (keep, "Events", @(t, x) tears (t, x, s)));
  else
    times = [t; release(t, x, s, last)];
    states = [x'; x'];
  endif
  t = times(end); x = states(end,:)';
  within = times >= last - 2 * pi;
  relative = max ([relative; abs(states(within,contact))]);
  absolute = max ([absolute; abs(states(within,contact) + base * cos (times(within)))]);
  if t < last
    force = load_of (t, x, s);
    x(n + s.j) = 0;
    way = sign (force) * (! was || abs (force) > beta);
    if within(end)
      count += was && ! way;
      reversals += was && way;
    endif
  endif
endwhile
printf ("%.0f %d %s %d %d %.17g %.17g\n", 1e6 * toc (start), cycles, "unchecked", ...
        count, reversals, relative, absolute);

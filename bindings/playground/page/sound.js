// Plays the sound of a mass: its velocity over one period, repeated.
class Sound {
  constructor() {
    this.on = false;
    this.heard = true;
  }

  // Returns the pitch in Hz. A low frequency rises by whole octaves until it is audible.
  pitch(hertz) {
    if (!this.heard) return hertz;
    let pitch = hertz;
    while (pitch < 80) pitch *= 2;
    while (pitch > 1200) pitch /= 2;
    return pitch;
  }

  show(orbit, mass, hertz) {
    this.asked = { orbit, mass, hertz };
    if (!this.on || !orbit?.motion) return this.silence();
    this.context ??= new AudioContext();
    this.context.resume();
    const motion = orbit.motion;
    const values = motion.masses[mass] ?? motion.masses[0];
    const slopes = values.slice(1).map((value, index) => value - values[index]);
    const most = Math.max(...slopes.map(Math.abs)) || 1;
    const length = Math.max(8, Math.round(this.context.sampleRate * motion.cycles / this.pitch(hertz)));
    const buffer = this.context.createBuffer(1, length, this.context.sampleRate);
    const data = buffer.getChannelData(0);
    for (let index = 0; index < length; index += 1) {
      const place = index / length * slopes.length;
      const low = Math.floor(place);
      const next = slopes[(low + 1) % slopes.length];
      data[index] = (slopes[low] + (next - slopes[low]) * (place - low)) / most;
    }
    const [source, gain] = [this.context.createBufferSource(), this.context.createGain()];
    source.buffer = buffer;
    source.loop = true;
    source.connect(gain).connect(this.context.destination);
    const now = this.context.currentTime;
    gain.gain.setValueAtTime(0, now);
    gain.gain.linearRampToValueAtTime(0.25, now + 0.03);
    this.silence();
    source.start();
    this.playing = { source, gain };
  }

  silence() {
    if (!this.playing) return;
    const { source, gain } = this.playing;
    const now = this.context.currentTime;
    gain.gain.setTargetAtTime(0, now, 0.015);
    source.stop(now + 0.1);
    this.playing = null;
  }
}

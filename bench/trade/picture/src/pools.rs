//! Combines the rows of `trade.csv` into the marks of the picture.

/// One mark of the picture: one method for one answer with one number of masses, over all contacts and dampings.
#[derive(Clone, Debug, PartialEq)]
pub struct Pool {
    /// Name of the method.
    pub by: String,
    /// Name of the computed quantity.
    pub answer: String,
    /// Number of masses.
    pub masses: usize,
    /// Median of the times over the scenes, in ns.
    pub time: f64,
    /// Largest relative error over the scenes, at usual points.
    pub error: f64,
}

/// Names of the columns of `trade.csv` that the picture uses.
const COLUMNS: [&str; 7] = [
    "scene",
    "masses",
    "zeta",
    "by",
    "answer",
    "median ns",
    "usual error p99",
];

struct Row {
    by: String,
    answer: String,
    masses: usize,
    time: f64,
    error: f64,
}

/// Returns a pool for each method, answer and number of masses, in the order of their first rows.
///
/// # Errors
/// Fails if a column is missing, or if a cell is not a number.
pub fn pools(table: &str) -> Result<Vec<Pool>, String> {
    let mut lines = table.lines();
    let head = cells(lines.next().unwrap_or_default());
    let place = |name: &&str| {
        let found = head.iter().position(|column| column == name);
        found.ok_or_else(|| format!("no column {name}"))
    };
    let places: Vec<usize> = COLUMNS.iter().map(place).collect::<Result<_, _>>()?;
    let mut rows = Vec::new();
    for line in lines {
        rows.extend(row(line, &places)?);
    }
    let mut pools: Vec<Pool> = Vec::new();
    for first in &rows {
        let of_way = |by: &str, answer: &str, masses| {
            (by, answer, masses) == (&first.by, &first.answer, first.masses)
        };
        if pools.iter().any(|p| of_way(&p.by, &p.answer, p.masses)) {
            continue;
        }
        let same = rows.iter().filter(|r| of_way(&r.by, &r.answer, r.masses));
        let mut times: Vec<f64> = same.clone().map(|row| row.time).collect();
        times.sort_by(f64::total_cmp);
        pools.push(Pool {
            by: first.by.clone(),
            answer: first.answer.clone(),
            masses: first.masses,
            time: times[times.len() / 2],
            error: same.map(|row| row.error).fold(0.0, f64::max),
        });
    }
    Ok(pools)
}

/// Parses a row of `trade.csv`. Returns `None` if the row has no time or no error, or if its value belongs to another
/// scene.
fn row(line: &str, places: &[usize]) -> Result<Option<Row>, String> {
    let cells = cells(line);
    let cell = |index: usize| cells.get(places[index]).map_or("", String::as_str);
    let number = |index: usize| match cell(index) {
        "" => Ok(f64::NAN),
        text => text
            .parse::<f64>()
            .map_err(|_| format!("no number: {line}")),
    };
    let (scene, by, answer) = (cell(0), cell(3), cell(4));
    let (masses, zeta, time, error) = (number(1)?, number(2)?, number(5)?, number(6)?);
    // The event stepper damps the motion relative to the base. With damping and a moving base it therefore computes
    // another scene.
    let other = by == "C event stepper" && scene.starts_with("Base") && zeta > 0.0;
    let shown = time > 0.0 && time.is_finite() && error.is_finite() && !other;
    Ok(shown.then(|| Row {
        by: by.to_owned(),
        answer: answer.to_owned(),
        masses: masses as usize,
        time,
        error,
    }))
}

/// Splits a line of a CSV file into its cells. A comma within quotes belongs to a cell.
fn cells(line: &str) -> Vec<String> {
    let mut cells = vec![String::new()];
    let mut quoted = false;
    for letter in line.chars() {
        match (letter, cells.last_mut()) {
            ('"', _) => quoted = !quoted,
            (',', _) if !quoted => cells.push(String::new()),
            (_, Some(cell)) => cell.push(letter),
            (_, None) => {}
        }
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::pools;

    const HEAD: &str = "scene,masses,zeta,by,answer,median ns,least ns,usual error p99\n";

    #[test]
    fn the_middle_time_and_the_largest_error() {
        let rows = [
            "Wall2,2,0,us,\"limits, exact\",30.0,29.0,1e-9",
            "Base2,2,0,us,\"limits, exact\",10.0,9.0,2e-9",
            "Pair2,2,0,us,\"limits, exact\",20.0,19.0,",
            "Pair2,2,0.02,us,\"limits, exact\",50.0,19.0,1e-10",
            "Wall5,5,0,us,\"limits, exact\",70.0,19.0,0",
        ];
        let found = pools(&(HEAD.to_owned() + &rows.join("\n"))).unwrap();
        let shown: Vec<_> = found.iter().map(|p| (p.masses, p.time, p.error)).collect();
        assert_eq!(shown, [(2, 30.0, 2e-9), (5, 70.0, 0.0)]);
        assert_eq!(found[0].answer, "limits, exact");
    }

    #[test]
    fn the_stepper_s_other_scene_is_left_out() {
        let row = |scene, zeta| format!("{scene},1,{zeta},C event stepper,a,5.0,5.0,0.1\n");
        let of = |text: String| pools(&(HEAD.to_owned() + &text)).unwrap().len();
        assert_eq!(of(row("Base1", 0.02)), 0);
        assert_eq!(of(row("Base1", 0.0)), 1);
        assert_eq!(of(row("Wall1", 0.02)), 1);
    }

    #[test]
    fn what_cannot_be_read_is_said() {
        assert_eq!(pools("scene\n").unwrap_err(), "no column masses");
        assert!(pools(&format!("{HEAD}Wall1,1,0,us,a,fast,1,1")).is_err());
    }
}

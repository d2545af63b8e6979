//! `history.csv`: the measures of a run over time, one row an interval.

use super::{Measures, ObserveError, Observer, Schedule, View, whole_file};
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use std::fs::{self, File, OpenOptions};
use std::path::{Path, PathBuf};

/// One row of the history of a weld; its fields are the columns of the table.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct HistoryRow {
    /// Physical time.
    pub time_s: f64,
    /// Steps taken.
    pub step: u64,
    /// Length of the last step.
    pub dt_s: f64,
    /// The limit that ruled the last step.
    pub dt_limit: String,
    /// Highest temperature of any particle.
    pub peak_temperature_k: f64,
    /// Width of the pool at the liquidus.
    pub pool_width_m: f64,
    /// Length of the pool at the liquidus.
    pub pool_length_m: f64,
    /// Depth of the pool at the liquidus.
    pub pool_depth_m: f64,
    /// Volume of the melt.
    pub melt_volume_m3: f64,
    /// Highest speed of any particle.
    pub max_speed_m_s: f64,
    /// Energy received since the start.
    pub energy_in_j: f64,
    /// Energy stored since the start.
    pub energy_stored_j: f64,
    /// Energy lost since the start.
    pub energy_lost_j: f64,
    /// What the ledger cannot account for, relative to the energy received.
    pub energy_residual_rel: f64,
    /// Largest von Mises stress; empty where no stress is computed, as those below.
    pub max_von_mises_pa: Option<f64>,
    /// Largest principal stress, tension positive.
    pub max_principal_stress_pa: Option<f64>,
    /// Smallest principal stress.
    pub min_principal_stress_pa: Option<f64>,
    /// Largest displacement from the start.
    pub max_displacement_m: Option<f64>,
    /// Largest equivalent plastic strain.
    pub max_plastic_strain: Option<f64>,
}

/// Writes the history as the run goes; each row is in the file before the run goes on.
///
/// A row is of the first step at or after each whole multiple of the interval: the history asks for no times of its
/// own, so a run takes the same steps however often it is written down.
///
/// In a resumed run (its first view has a step above zero) the rows that the unbroken run would not have at that
/// moment are cut off first: those after the checkpoint, and the closing row of the interrupted run.
pub struct HistoryWriter {
    path: PathBuf,
    schedule: Schedule,
    table: Option<csv::Writer<File>>,
    written_s: Option<f64>,
}

impl HistoryWriter {
    /// A history at `path` with a row each `interval_s`, one at the start and one at the end.
    pub fn new(path: impl Into<PathBuf>, interval_s: f64) -> Self {
        HistoryWriter { path: path.into(), schedule: Schedule::new(interval_s), table: None, written_s: None }
    }

    fn open(&mut self, resumed_at_s: Option<f64>) -> Result<(), ObserveError> {
        let mut kept = Vec::new();
        if let Some(time_s) = resumed_at_s.filter(|_| self.path.exists()) {
            kept = fs::read(&self.path).map_err(ObserveError::file("read", &self.path))?;
            let (bytes, written_s) = kept_rows(&kept, &mut self.schedule, time_s);
            kept.truncate(bytes);
            self.written_s = written_s;
        }
        let file = whole_file::replace(&self.path, &kept)
            .and_then(|()| OpenOptions::new().append(true).open(&self.path))
            .map_err(ObserveError::file("open", &self.path))?;
        let table = csv::WriterBuilder::new().has_headers(kept.is_empty()).from_writer(file);
        self.table = Some(table);
        Ok(())
    }

    fn write(&mut self, time_s: f64, row: &Measures) -> Result<(), ObserveError> {
        self.schedule.advance_past(time_s);
        if self.written_s == Some(time_s) {
            return Ok(());
        }
        let Some(table) = &mut self.table else { return Ok(()) };
        table.serialize(row).map_err(|source| ObserveError::Table { path: self.path.clone(), source })?;
        table.flush().map_err(ObserveError::file("write", &self.path))?;
        self.written_s = Some(time_s);
        Ok(())
    }
}

impl<const D: usize> Observer<D> for HistoryWriter {
    fn is_due(&self, time_s: f64) -> bool {
        self.schedule.is_due(time_s)
    }

    fn init(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        self.open((view.step > 0).then_some(view.time_s))?;
        if view.step == 0 { self.write(view.time_s, &view.history) } else { Ok(()) }
    }

    fn every(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        if self.schedule.is_due(view.time_s) { self.write(view.time_s, &view.history) } else { Ok(()) }
    }

    fn finish(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        self.write(view.time_s, &view.history)
    }
}

/// Reads a history back, as rows of its kind of scene.
pub fn read_history<Row: DeserializeOwned>(path: &Path) -> Result<Vec<Row>, ObserveError> {
    let table_error = |source| ObserveError::Table { path: path.to_path_buf(), source };
    let mut reader = csv::Reader::from_path(path).map_err(table_error)?;
    reader.deserialize().collect::<Result<_, _>>().map_err(table_error)
}

/// The one column that the history of every scene has.
#[derive(Deserialize)]
struct Clock {
    time_s: f64,
}

/// How many bytes of a table the unbroken run would have at `time_s`, and the time of the last row among them; leaves
/// `schedule` where that row left it.
fn kept_rows(text: &[u8], schedule: &mut Schedule, time_s: f64) -> (usize, Option<f64>) {
    // A row without its line end was cut off when the program died: its last number may be short.
    let whole = &text[..text.iter().rposition(|&byte| byte == b'\n').map_or(0, |last| last + 1)];
    let mut reader = csv::Reader::from_reader(whole);
    let (mut kept_bytes, mut last_s) = (0, None);
    let mut rows = reader.deserialize::<Clock>();
    while let Some(Ok(row)) = rows.next() {
        if row.time_s > time_s || !schedule.is_due(row.time_s) {
            break;
        }
        schedule.advance_past(row.time_s);
        kept_bytes = rows.reader().position().byte() as usize;
        last_s = Some(row.time_s);
    }
    (kept_bytes, last_s)
}

#[cfg(test)]
mod tests {
    use super::*;

    const INTERVAL_S: f64 = 0.1;
    const STEP_S: f64 = 0.03;
    const END_S: f64 = 1.05;

    /// A run of steps that know nothing of the history; gives back the clock it stopped at.
    fn run(path: &Path, from: (f64, u64), stop_s: f64) -> (f64, u64) {
        let mut writer = HistoryWriter::new(path, INTERVAL_S);
        let (mut time_s, mut step) = from;
        Observer::<2>::init(&mut writer, &view(time_s, step)).unwrap();
        while time_s < stop_s {
            time_s = (time_s + STEP_S).min(END_S);
            step += 1;
            Observer::<2>::every(&mut writer, &view(time_s, step)).unwrap();
        }
        Observer::<2>::finish(&mut writer, &view(time_s, step)).unwrap();
        (time_s, step)
    }

    fn view(time_s: f64, step: u64) -> View<'static, 2> {
        let history = HistoryRow {
            time_s,
            step,
            peak_temperature_k: 300.0 + (7.0 * time_s).sin(),
            dt_limit: "conduction, explicit".into(),
            ..HistoryRow::default()
        };
        View { history: Measures::Weld(history), ..View::bare(time_s, step) }
    }

    #[test]
    fn rows_come_at_the_first_step_of_every_interval_at_the_start_and_at_the_end() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("history.csv");
        run(&path, (0.0, 0), END_S);
        let rows: Vec<HistoryRow> = read_history(&path).unwrap();
        assert_eq!(rows.len(), 12);
        assert_eq!((rows[0].time_s, rows[11].time_s), (0.0, END_S));
        for (index, row) in rows.iter().enumerate().take(11).skip(1) {
            let due_s = index as f64 * INTERVAL_S;
            assert!((due_s..due_s + STEP_S + 1e-12).contains(&row.time_s), "{index}: {}", row.time_s);
        }
        assert_eq!(Measures::Weld(rows[3].clone()), view(rows[3].time_s, rows[3].step).history);
    }

    #[test]
    fn the_columns_are_those_of_the_contract() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("history.csv");
        run(&path, (0.0, 0), 0.0);
        let text = fs::read_to_string(&path).unwrap();
        let header = "time_s,step,dt_s,dt_limit,peak_temperature_k,pool_width_m,pool_length_m,pool_depth_m,\
                      melt_volume_m3,max_speed_m_s,energy_in_j,energy_stored_j,energy_lost_j,energy_residual_rel,\
                      max_von_mises_pa,max_principal_stress_pa,min_principal_stress_pa,max_displacement_m,max_plastic_strain";
        assert_eq!(text.lines().next().unwrap(), header);
        assert_eq!(text.lines().count(), 2);
    }

    #[test]
    fn a_resumed_history_equals_the_unbroken_one_wherever_it_was_broken() {
        let folder = tempfile::tempdir().unwrap();
        let (unbroken, broken) = (folder.path().join("unbroken.csv"), folder.path().join("broken.csv"));
        run(&unbroken, (0.0, 0), END_S);
        for tenth in 1..21 {
            // Interrupted at a checkpoint, off the interval or on it ...
            let checkpoint = run(&broken, (0.0, 0), 0.05 * tenth as f64);
            run(&broken, checkpoint, END_S);
            assert_eq!(fs::read(&broken).unwrap(), fs::read(&unbroken).unwrap());
            // ... and killed long after it, in the middle of a row.
            let text = fs::read(&broken).unwrap();
            fs::write(&broken, &text[..text.len() - 3]).unwrap();
            run(&broken, checkpoint, END_S);
            assert_eq!(fs::read(&broken).unwrap(), fs::read(&unbroken).unwrap());
        }
    }

    #[test]
    fn a_fresh_run_starts_the_table_anew_and_a_missing_folder_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("history.csv");
        run(&path, (0.0, 0), END_S);
        run(&path, (0.0, 0), 0.0);
        assert_eq!(read_history::<HistoryRow>(&path).unwrap().len(), 1);
        let mut lost = HistoryWriter::new(folder.path().join("none/history.csv"), INTERVAL_S);
        let error = Observer::<2>::init(&mut lost, &view(0.0, 0)).unwrap_err();
        assert!(error.to_string().contains("none/history.csv"), "{error}");
    }
}

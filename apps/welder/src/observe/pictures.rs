//! Pictures for people who would rather look: sections whenever the view brings them, the history at the end.

use super::section_picture::draw_section;
use super::{ObserveError, Observer, View};
use std::path::{Path, PathBuf};

/// Draws the sections of a view as PNG, and at the end the history from `history.csv`.
///
/// It must come after the [`HistoryWriter`](super::HistoryWriter) among the observers, since it draws what that one
/// has written: so a resumed run shows the whole history.
pub struct PictureWriter {
    folder: PathBuf,
}

impl PictureWriter {
    /// Pictures in `run_folder`.
    pub fn new(run_folder: &Path) -> Self {
        PictureWriter { folder: run_folder.to_path_buf() }
    }

    fn draw<const D: usize>(&self, view: &View<D>) -> Result<(), ObserveError> {
        let mut sections = view.pictures.iter().flat_map(|pictures| &pictures.sections);
        sections.try_for_each(|(stem, grid)| draw_section(&self.folder.join(format!("{stem}.png")), grid))
    }
}

impl<const D: usize> Observer<D> for PictureWriter {
    fn init(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        self.draw(view)
    }

    fn every(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        self.draw(view)
    }

    fn finish(&mut self, view: &View<D>) -> Result<(), ObserveError> {
        self.draw(view)?;
        let history = self.folder.join("history.csv");
        if history.exists() {
            view.history.draw_history(&self.folder.join("history.png"), &history)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observe::{HistoryWriter, Pictures, SectionGrid};

    fn view(pictures: Option<Pictures>) -> View<'static, 2> {
        View { pictures, ..View::bare(0.0, 0) }
    }

    #[test]
    fn sections_come_with_the_view_and_the_history_at_the_end() {
        let folder = tempfile::tempdir().unwrap();
        let there = |name: &str| folder.path().join(name).exists();
        let mut history = HistoryWriter::new(folder.path().join("history.csv"), 0.1);
        let mut pictures = PictureWriter::new(folder.path());
        history.init(&view(None)).unwrap();
        pictures.init(&view(None)).unwrap();
        assert!(!there("top.png"));
        let grid = SectionGrid {
            title: "From above".into(),
            x_label: "x",
            y_label: "y",
            x_m: vec![0.0, 1.0],
            y_m: vec![0.0, 1.0],
            quantity: "temperature, K",
            value: vec![1.0, 2.0, 3.0, 4.0],
            levels: vec![(2.5, "liquidus")],
            levels_of: None,
        };
        pictures.every(&view(Some(Pictures { sections: vec![("top".into(), grid)] }))).unwrap();
        assert!(there("top.png") && !there("history.png"));
        pictures.finish(&view(None)).unwrap();
        assert!(there("history.png"));
    }
}

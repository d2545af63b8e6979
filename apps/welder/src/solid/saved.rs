//! The columns of bodies in a checkpoint.

use super::model::SolidModel;
use super::patch::Patch;
use crate::observe::{Checkpoint, CheckpointError};
use nalgebra::SMatrix;
use sph_solid::SymmetricTensor;

/// Numbers of a tensor, the one out of the plane last.
fn flat<const D: usize>(tensors: &[SymmetricTensor<D>]) -> Vec<f64> {
    tensors.iter().flat_map(|tensor| tensor.in_plane.iter().copied().chain([tensor.out_of_plane])).collect()
}

fn tensors<const D: usize>(flat: &[f64]) -> Vec<SymmetricTensor<D>> {
    let tensor = |flat: &[f64]| SymmetricTensor {
        in_plane: SMatrix::from_column_slice(&flat[..D * D]),
        out_of_plane: flat[D * D],
    };
    flat.chunks_exact(D * D + 1).map(tensor).collect()
}

impl<const D: usize> Patch<D> {
    /// Puts everything that changes into a checkpoint; temperatures follow from the time.
    pub fn save(&self, checkpoint: &mut Checkpoint) -> Result<(), CheckpointError> {
        checkpoint.put_vectors("velocity_m_s", self.velocities())?;
        checkpoint.put_column("plastic_strain", self.equivalents())?;
        match self {
            Patch::Updated(patch) => {
                checkpoint.put_vectors("position_m", &patch.positions)?;
                checkpoint.put_column("density_kg_m3", &patch.densities)?;
                checkpoint.put_column("deviator_pa", &flat(&patch.deviators))
            }
            Patch::Total(patch) => {
                checkpoint.put_vectors("displacement_m", &patch.displacements)?;
                checkpoint.put_column("inelastic_strain", &flat(&patch.strains))
            }
        }
    }

    /// Takes up a checkpoint of `time` \[s\].
    pub fn restore(
        &mut self,
        checkpoint: &Checkpoint,
        model: &SolidModel<D>,
        time: f64,
    ) -> Result<(), CheckpointError> {
        let (count, in_tensors) = (model.positions.len(), model.positions.len() * (D * D + 1));
        let velocities = checkpoint.vectors("velocity_m_s", count)?;
        let equivalents = checkpoint.numbers("plastic_strain", count)?;
        self.set_temperatures(model, time);
        match self {
            Patch::Updated(patch) => {
                patch.positions = checkpoint.vectors("position_m", count)?;
                patch.densities = checkpoint.numbers("density_kg_m3", count)?;
                patch.deviators = tensors(&checkpoint.numbers("deviator_pa", in_tensors)?);
                (patch.velocities, patch.equivalents) = (velocities, equivalents);
            }
            Patch::Total(patch) => {
                let strains = tensors(&checkpoint.numbers("inelastic_strain", in_tensors)?);
                patch.displacements = checkpoint.vectors("displacement_m", count)?;
                patch.strains.clone_from(&strains);
                patch.velocities = velocities;
                // Places and stresses for who asks before the next step; what yields by a hair is put back.
                patch.evaluate();
                (patch.strains, patch.equivalents) = (strains, equivalents);
            }
        }
        Ok(())
    }
}

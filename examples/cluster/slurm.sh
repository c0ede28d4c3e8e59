#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Computes sweep.dom as a job array of Slurm: task I computes part I. If tasks were lost, submit only these again, with
# '--array=7,31'.
#
#SBATCH --job-name=domino
#SBATCH --array=1-18
#SBATCH --cpus-per-task=1
#SBATCH --mem=100M
#SBATCH --time=01:00:00
set -eu
part=$(printf %02d "$SLURM_ARRAY_TASK_ID")
"${DOMINO:-domino}" -e "let part = $part; set threads ${SLURM_CPUS_PER_TASK:-1}" -f "${1:-sweep.dom}" >"part-$part.csv.new"
mv "part-$part.csv.new" "part-$part.csv"

#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The sweep as a job array of Slurm: task I of N computes part I of N.
#
#   sbatch slurm.sh                              20 parts, part-01.csv ... part-20.csv
#   sbatch --array=1-50 slurm.sh placement.dom   50 parts of the study of placement
#
# When all are done the whole is
#
#   cat part-*.csv > sweep.csv
#   cat part-*.csv | domino -e 'pool -'          of the study
#
#SBATCH --job-name=domino
#SBATCH --array=1-20
#SBATCH --cpus-per-task=1
#SBATCH --mem=100M
#SBATCH --time=01:00:00
set -eu
scene=${1:-sweep.dom}
part=$SLURM_ARRAY_TASK_ID
parts=$SLURM_ARRAY_TASK_COUNT
domino=${DOMINO:-domino}

# Names whose order is that of the parts, however many there are.  A part that is not whole has another name:
# the last step is to call it what it is.
name=part-$(printf "%0${#parts}d" "$part").csv
"$domino" --shard "$part/$parts" -e "set threads ${SLURM_CPUS_PER_TASK:-1}" -f "$scene" >"$name.new"
mv "$name.new" "$name"

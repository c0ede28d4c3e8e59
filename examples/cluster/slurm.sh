#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Computes a scene as a job array of Slurm: task I of N computes part I of N.
#
#   sbatch slurm.sh                               20 parts of the sweep, part-01.csv ... part-20.csv
#   sbatch --array=1-100 slurm.sh map.dom         a map of a million points
#   sbatch slurm.sh improve.dom                   'improve' from 20 seeds; choose the best
#
# When all tasks are done, combine the parts with 'cat part-*.csv > sweep.csv'.
#
# If tasks were lost, submit the same command again: it computes only the parts that are missing. To run only tasks 7
# and 31, use '--array=7,31', and give the number of parts with '--export=ALL,PARTS=50'.
#
#SBATCH --job-name=domino
#SBATCH --array=1-20
#SBATCH --cpus-per-task=1
#SBATCH --mem=100M
#SBATCH --time=01:00:00
set -eu
scene=${1:-sweep.dom}
part=$SLURM_ARRAY_TASK_ID
parts=${PARTS:-$SLURM_ARRAY_TASK_COUNT}
# Slurm runs a copy of this script, in the folder from which it was submitted.
here=$(cd "$(dirname "$scene")" && pwd)

# These file names sort in the order of the parts, however many there are.
THREADS=${SLURM_CPUS_PER_TASK:-1} "$here/part.sh" "$scene" "$part" "$parts" "part-$(printf "%0${#parts}d" "$part").csv"

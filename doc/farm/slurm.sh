#!/bin/sh
# A film by a Slurm cluster, as a job array. Send it off from where the scene lies:
#
#   sbatch --array=0-15 doc/farm/slurm.sh SCENE FOLDER FRAMES
#
# FRAMES is the number of the last frame. Each of the 16 tasks takes every 16th frame, so that a slow
# part of the film is spread over all of them. A task that was killed is sent again by Slurm
# (--requeue): it goes on with the frame that it was at. Sent again by hand, the whole array passes over
# what is there. When all are done:
#
#   dioptre animate FOLDER/%05d.png --frames 0-FRAMES -o film.mp4
#
#SBATCH --job-name=dioptre
#SBATCH --cpus-per-task=1
#SBATCH --requeue
#SBATCH --output=dioptre-%A-%a.log
set -eu
scene=$1 folder=$2 last=$3
first=$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN))
mkdir -p "$folder"
[ "$first" -le "$last" ] || exit 0 # A film with fewer frames than tasks.
# shellcheck disable=SC2086 # OPTIONS is a list
exec "${DIOPTRE:-dioptre}" animate "$scene" --threads "${SLURM_CPUS_PER_TASK:-1}" --skip-existing \
    --progress none ${OPTIONS:-} --frames "$first-$last:$SLURM_ARRAY_TASK_COUNT" -o "$folder/%05d.png"

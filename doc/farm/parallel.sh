#!/bin/sh
# A film by many machines, with GNU parallel over ssh. Every frame is a job: a machine that fails, or
# is switched off, loses its own frame and no other. Run it again after any accident: frames that are
# there and whole are not drawn again (--skip-existing).
#
#   doc/farm/parallel.sh SCENE FOLDER FRAMES [HOSTS]
#
# SCENE and FOLDER lie where all hosts see them under the same name (NFS), and dioptre is installed on
# all of them, the same version. FRAMES is the number of the last frame. HOSTS is a file with a line a
# host, such as `4/teacher@room12-07`: four jobs at once there, `:` is this machine. OPTIONS may hold
# options of dioptre. Each job draws with one thread: as many jobs as a machine has cores. Frames are
# BMP: a program that starts for one frame need not load the libraries of other formats.
set -eu
scene=$1 folder=$2 last=$3 hosts=${4:-}
mkdir -p "$folder"
if [ -n "$hosts" ]; then
    set -- --sshloginfile "$hosts" --workdir "$PWD" --filter-hosts
else
    set -- --jobs "${JOBS:-100%}"
fi
# shellcheck disable=SC2086 # OPTIONS is a list
seq 0 "$last" | parallel "$@" --quote --joblog "$folder/jobs.log" --retries 3 --halt never \
    "${DIOPTRE:-dioptre}" animate "$scene" --threads 1 --quiet --skip-existing ${OPTIONS:-} \
    --frames {} -o "$folder/%05d.bmp"
"${DIOPTRE:-dioptre}" animate "$folder/%05d.bmp" --frames "0-$last" -o "$folder/film.mp4"

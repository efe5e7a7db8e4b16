#!/bin/sh
# How many pixels of each scene have acne or a leak in float: doc/figures/acne.csv. Called by `make bench`.
# Environment: BUILD (folder of the program; build), MADE_WITH (compiler and flags, for the file).
set -eu
cd "$(dirname "$0")/../.."
. tests/peers/figures.sh
rows=$("${BUILD:-build}/bench-acne" scenes/*.lua)
begin_figures acne scene,pixels,acne,leaks
keep_figures acne "$rows"

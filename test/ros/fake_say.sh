#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Stands in for a program that speaks: fake_say.sh FOLDER ARG… writes what it was told, a line each, to
# FOLDER/said.N and its process id to FOLDER/pid.N, and speaks for as long as there is FOLDER/hold.
folder=$1
shift
count=$(find "$folder" -name 'pid.*' | wc -l)
printf '%s\n' "$@" >"$folder/said.part"
mv "$folder/said.part" "$folder/said.$count"
echo $$ >"$folder/pid.part"
mv "$folder/pid.part" "$folder/pid.$count"
while [ -e "$folder/hold" ]; do sleep 0.02; done

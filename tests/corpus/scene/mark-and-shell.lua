#!/usr/bin/dioptre
camera {} include "box.lua"
/**
 * @file
 * @brief Scenes in NFF, the Neutral File Format of the Standard Procedural Databases
 * (Haines, *A Proposal for Standard Graphics Environments*, 1987).
 */
#ifndef DIOPTRE_SCRIPT_NFF_H
#define DIOPTRE_SCRIPT_NFF_H

#include "script/script_run.h"

/**
 * Reads an NFF text into a scene. Only for worker processes.
 * @param[in,out] run  The run; its scene and its report are filled.
 */
void nff_execute(ScriptRun *run);

#endif

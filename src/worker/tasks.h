/**
 * @file
 * @brief All tasks of a worker.
 */
#ifndef DIOPTRE_WORKER_TASKS_H
#define DIOPTRE_WORKER_TASKS_H

#include "assets/process/worker_main.h"

/** The tasks, ended by one without a name. */
extern const WorkerTask worker_tasks[];

#endif

/**
 * @file
 * @brief What is wrong when a worker does not hand over what a file holds.
 */
#ifndef DIOPTRE_ASSETS_ASSET_FAILURE_H
#define DIOPTRE_ASSETS_ASSET_FAILURE_H

#include "assets/process/worker_process.h"

/** A reply without a result. */
typedef struct AssetFailure {
    const WorkerReply *reply; /**< The reply. */
    const Error *reported;    /**< The error in its report. */
    double time_limit;        /**< Its limit of processor time, seconds. */
    bool is_time_shared;      /**< Whether that is what other files of the scene have left. */
    const char *no_process;   /**< Message where no worker could be started, with one %s. */
    const char *crash;        /**< Message where it crashed, with one %s. */
} AssetFailure;

/** Sets the error of a reply without a result. @return false, always. */
bool asset_failure_set(const AssetFailure *failure, Error *error);

#endif

/**
 * @file
 * @brief What is wrong when a worker does not hand over what a file holds.
 */
#include "assets/asset_failure.h"

#include "assets/asset_budget.h"

#include <libintl.h>
#include <string.h>

bool asset_failure_set(const AssetFailure *failure, Error *error) {
    const WorkerReply *reply = failure->reply;
    char reason[WORKER_REASON_SIZE];
    if (worker_reply_start_failure(reply, reason)) {
        return error_set(error, STATUS_FAILED, failure->no_process, reason);
    }
    if (reply->end == WORKER_TIMED_OUT && failure->is_time_shared && !reply->is_stalled) {
        return asset_budget_set_time_error(error);
    }
    if (reply->end == WORKER_TIMED_OUT) {
        return error_set(error, STATUS_SCENE, "it takes more than %.0f s to read",
                         failure->time_limit);
    }
    if (worker_reply_is_interrupted(reply)) {
        return error_set(error, STATUS_INTERRUPTED, "interrupted");
    }
    if (reply->end == WORKER_FINISHED && failure->reported->status != STATUS_OK) {
        return worker_error_set(error, failure->reported);
    }
    return error_set(error, STATUS_SCENE, failure->crash,
                     reply->detail ? strsignal(reply->detail) : gettext("it ended early"));
}

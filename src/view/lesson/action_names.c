/**
 * @file
 * @brief The names that lessons have for commands.
 */
#include "view/lesson/action_names.h"

#include "dioptre/view.h"
#include "view/commands/commands.h"

/** Finds the next command that is a move, or that is none. @return NULL: there is no other. */
static const Command *next_named(const Command *row, bool is_move) {
    while (command_is_row(row) && (!row->name || command_is_move(row) != is_move)) {
        row++;
    }
    return command_is_row(row) ? row : NULL;
}

const Command *command_of_action(int action) {
    for (int is_move = 1; is_move >= 0; is_move--) {
        const Command *row = next_named(command_table, is_move);
        for (; row; row = next_named(row + 1, is_move)) {
            if (action-- == 0) {
                return row;
            }
        }
    }
    return NULL;
}

int view_actions(const char *names[VIEW_ACTIONS_MAXIMUM]) {
    int count = 0, move_count = 0;
    for (const Command *row;
         count < VIEW_ACTIONS_MAXIMUM - 1 && (row = command_of_action(count));) {
        names[count++] = row->name;
        move_count += command_is_move(row);
    }
    names[count] = NULL;
    return move_count;
}

/**
 * @file
 * @brief Comparing choices.
 */
#include "view/state/picture_choice.h"

bool picture_choice_is_same(const PictureChoice *a, const PictureChoice *b,
                            const RenderSettings *base) {
    const size_t count = a->split == SPLIT_NONE ? 1 : CHOICE_PICTURES;
    bool is_same = a->split == b->split;
    for (size_t i = 0; i < count; i++) {
        RenderSettings of_a = *base, of_b = *base;
        settings_override_apply(&a->overrides[i], &of_a);
        settings_override_apply(&b->overrides[i], &of_b);
        is_same = is_same && a->layers[i] == b->layers[i] && settings_difference(&of_a, &of_b) == 0;
    }
    return is_same;
}

/**
 * @file
 * @brief What a scene file needs that no time changes.
 */
#ifndef SCRIPT_STOCK_H
#define SCRIPT_STOCK_H

#include "dioptre/script.h"
#include "script/source.h"

/** @return The text of the scene file, empty until it is read; owned by the stock. @param stock The
 *  stock. */
Source *stock_source(Stock *stock);

/**
 * Gives a scene the models and pictures that it names and that are in a stock.
 * @param stock          The stock; NULL: nothing is in it.
 * @param[in,out] scene  The scene; it becomes one of their owners.
 */
void stock_lend(const Stock *stock, Scene *scene);

/**
 * Keeps the models and pictures of a scene, and no others: a film whose every frame has a picture
 * of its own must not fill the memory.
 * @param[in,out] stock  The stock, which becomes one of their owners; NULL: nothing is kept.
 * @param scene          The scene, with all that it names.
 * @param[out] error     What is wrong.
 * @return false without memory; nothing is kept then.
 */
bool stock_keep(Stock *stock, const Scene *scene, Error *error);

#endif

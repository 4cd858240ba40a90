/* SPDX-License-Identifier: MIT
 * A folder of output files that appears when it is whole. Until then its files lie in a folder beside it, or within it
 * where it exists; if the program ends before, also by fail() or a signal, these go and nothing has changed: no call does that. */
#ifndef GLINT_BASE_FOLDER_H
#define GLINT_BASE_FOLDER_H

struct folder;
/* One at a time. Ends the program through fail() where nothing can be written there. */
struct folder *folder_open(const char *path);
/* Where the files lie until folder_close. */
const char *folder_work(const struct folder *folder);
/* The path of a file to write there; malloc'd. Any number of files, each name once. */
char *folder_file(struct folder *folder, const char *name);
/* Gives the folder, or in one that exists each of its files, the name it is to have. Other files there stay. Frees. */
void folder_close(struct folder *folder);

#endif

/* SPDX-License-Identifier: MIT
 * The commands that write files, as they are. */
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "commands/commands.h"
#include "files.h"
#include "page.h"
#include "words.h"

void page_run(char *text, size_t bytes)
{
    static const struct {
        const char *name;
        int (*run)(int argc, char **argv);
    } commands[] = {{"glint bake", command_bake}, {"glint material", command_material}, {"glint table", command_table}};
    struct words words;
    words_split(&words, text, bytes);
    files_forget();
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++)
        if (words.count && strcmp(words.list[0], commands[i].name) == 0) {
            commands[i].run(words.count, words.list);
            free(text);
            return;
        }
    fail("%s: the page does not run this command", words.count ? words.list[0] : "nothing");
}

uint32_t page_files(void)
{
    return files_written();
}

const char *page_file_name(uint32_t i)
{
    return files_get(i) ? files_get(i)->name : NULL;
}

const char *page_file_bytes(uint32_t i)
{
    return files_get(i) ? files_get(i)->bytes : NULL;
}

size_t page_file_length(uint32_t i)
{
    return files_get(i) ? files_get(i)->len : 0;
}

/* SPDX-License-Identifier: MIT
 * The subcommands of glint, one file each. argv[0] is "glint NAME", for messages; they return the exit status. */
#ifndef GLINT_COMMANDS_COMMANDS_H
#define GLINT_COMMANDS_COMMANDS_H

int command_render(int argc, char **argv);
int command_eval(int argc, char **argv);
int command_cutoff(int argc, char **argv);
int command_table(int argc, char **argv);
int command_bake(int argc, char **argv);
int command_material(int argc, char **argv);
int command_stream(int argc, char **argv);
int command_list(int argc, char **argv);
int command_search(int argc, char **argv);
int command_paper(int argc, char **argv);
int command_page(int argc, char **argv);

#endif

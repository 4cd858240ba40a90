/* SPDX-License-Identifier: MIT */
#include "sinks/outputs.h"

#include "base/argp.h"
#include "sinks/frames.h"

static void check_frames(const struct argp_state *state, const struct sink_kind *kind, const char *output,
                         unsigned long frames)
{
    if (!frame_pattern(state, "-o", output) && frames != 1 && !kind->usual_output)
        refuse(state,
               "-o: '%s' names one file for all frames; write %%04d where the frame's number goes (frame-%%04d.%s), or "
               "give --frames 1",
               output, kind->name);
}

const struct sink_output output_file_a_frame = {
    .word = "a file a frame",
    .written = "a file for each frame",
    .example = "frame-%04d.",
    .check = check_frames,
    .begin = frames_check,
};

const struct sink_output output_one_file = {
    .word = "one file",
    .written = "a file",
    .example = "FILE.",
    .dash = true,
};

const struct sink_output output_standard = {
    .word = "standard output",
    .piped = true,
};

const struct sink_output output_terminal = {
    .word = "terminal",
    .shown = true,
};

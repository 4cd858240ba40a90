// SPDX-License-Identifier: MIT
// An example of use: a line of cosines becomes grey pixels, ambient light plus a highlight, a pixel a clock. What
// goes with a pixel, here the mark of the line's last, travels through the core as its user bits. The cutoff is what
// glint_cutoff(GLINT_MSH, 60, 8) gives.
`default_nettype none

module highlight_grey (
    input wire clk,
    input wire rst,
    input wire in_valid,
    output wire in_ready,
    input wire signed [17:0] in_cosine,
    input wire in_last,
    output reg out_valid,
    input wire out_ready,
    output reg [7:0] out_grey,
    output reg out_last
);
    localparam [7:0] AMBIENT = 24;

    wire valid, last, idle;
    wire [16:0] f;
    wire ready = !out_valid || out_ready;
    glint_core #(
        .USER(1)
    ) core (
        .clk(clk),
        .rst(rst),
        .model(1'b0),
        .n(10'd60),
        .c_min(17'd47675),
        .s_valid(in_valid),
        .s_ready(in_ready),
        .s_c(in_cosine),
        .s_user(in_last),
        .m_valid(valid),
        .m_ready(ready),
        .m_f(f),
        .m_user(last),
        .idle(idle)
    );

    // 255 * 2^16 is 1.0; MSH reaches 1.024, so the sum is held.
    wire [25:0] sum = {2'd0, AMBIENT, 16'h8000} + {1'b0, f, 8'd0} - {9'd0, f};
    always @(posedge clk)
        if (rst) out_valid <= 0;
        else if (ready) begin
            out_valid <= valid;
            out_grey <= sum[25:24] != 0 ? 8'd255 : sum[23:16];
            out_last <= last;
        end

    wire unused = &{1'b0, sum[15:0], idle};
endmodule

`default_nettype wire

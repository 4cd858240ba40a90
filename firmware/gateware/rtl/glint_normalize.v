// SPDX-License-Identifier: MIT
// Shifts w, 2^18 <= w < 2^28, left until bit 27 is set: y = w << (9 - octave), octave 0..9. Two clocks; next is y a
// clock before.
`default_nettype none

module glint_normalize (
    input wire clk,
    input wire en,
    input wire [27:0] w,
    output wire [27:0] next,
    output reg [27:0] y,
    output reg [3:0] octave
);
    wire far8 = ~|w[27:20];
    wire [27:0] w8 = far8 ? {w[19:0], 8'd0} : w;
    wire far4 = ~|w8[27:24];
    wire [27:0] w4 = far4 ? {w8[23:0], 4'd0} : w8;

    reg [27:0] half;
    reg [3:0] rest;  // the octave, were half normalized
    always @(posedge clk)
        if (en) begin
            half <= w4;
            rest <= 4'd9 - {far8, far4, 2'd0};
        end

    wire far2 = ~|half[27:26];
    wire [27:0] w2 = far2 ? {half[25:0], 2'd0} : half;
    wire far1 = ~w2[27];
    assign next = far1 ? {w2[26:0], 1'b0} : w2;
    always @(posedge clk)
        if (en) begin
            y <= next;
            octave <= rest - {2'd0, far2, far1};
        end
endmodule

`default_nettype wire

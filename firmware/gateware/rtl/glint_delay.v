// SPDX-License-Identifier: MIT
// q is d of CLOCKS enabled clocks ago: a ring in block RAM, where registers would cost a logic cell a bit and clock.
`default_nettype none

module glint_delay #(
    parameter integer WIDTH = 16, // 1 or more
    parameter integer CLOCKS = 4, // 2..16
    parameter integer LUT_RAM = 0 // 1: in the memory of logic cells, on parts that have it
) (
    input wire clk,
    input wire rst,
    input wire en,
    input wire [WIDTH-1:0] d,
    output reg [WIDTH-1:0] q
);
    localparam [31:0] LAST = CLOCKS - 1;

    reg [3:0] place;
    // What is read is the oldest: written over a clock later. (Counted bit by bit: a carry chain would take more
    // cells.)
    wire [3:0] after = place ^ {&place[2:0], &place[1:0], place[0], 1'b1};
    wire [3:0] next = place == LAST[3:0] ? 4'd0 : after;

    always @(posedge clk)
        if (rst) place <= 0;
        else if (en) place <= next;

    generate
        if (LUT_RAM != 0) begin : cells
            (* ram_style = "distributed" *) reg [WIDTH-1:0] ring[0:15];
            always @(posedge clk)
                if (en) begin
                    ring[place] <= d;
                    q <= ring[next];
                end
        end else begin : block
            (* ram_style = "block" *) reg [WIDTH-1:0] ring[0:15];
            always @(posedge clk)
                if (en) begin
                    ring[place] <= d;
                    q <= ring[next];
                end
`ifdef FORMAL
            // Proved for ever, by induction: since the reset the ring holds what went in, the oldest where it writes
            // next.
            reg [WIDTH*CLOCKS-1:0] history; // the last lowest
            reg [4:0] held;
            integer i;
            always @(posedge clk)
                if (rst) held <= 0;
                else if (en) begin
                    held <= held == CLOCKS ? held : held + 5'd1;
                    history <= {history, d};
                end
            always @(posedge clk)
                if (!rst) begin
                    assert (held <= CLOCKS && place < CLOCKS);
                    for (i = 0; i < CLOCKS; i = i + 1)
                        if (i < held) assert (ring[(place + CLOCKS - 1 - i) % CLOCKS] == history[WIDTH*i+:WIDTH]);
                    if (held == CLOCKS) assert (q == history[WIDTH*(CLOCKS-1)+:WIDTH]);
                end
`endif
        end
        if (WIDTH < 1 || CLOCKS < 2 || CLOCKS > 16) begin : range
            WIDTH_must_be_1_or_more_and_CLOCKS_2_to_16 stop ();
        end
    endgenerate

    wire unused = &{1'b0, LAST[31:4]};
endmodule

`default_nettype wire

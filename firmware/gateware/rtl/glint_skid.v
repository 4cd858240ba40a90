// SPDX-License-Identifier: MIT
// Purpose: breaks the path from m_ready to s_ready: s_ready comes from a register, and no clock is lost.
// Parameters: WIDTH, bits of the data.
// Latency: 1 clock.
// Reset: synchronous, active high; empties it.
// Back-pressure: two places; while both are full s_ready is 0.
`default_nettype none

module glint_skid #(
    parameter integer WIDTH = 16 // 1 or more
) (
    input wire clk,
    input wire rst,
    input wire s_valid,
    output wire s_ready,
    input wire [WIDTH-1:0] s_data,
    output reg m_valid,
    input wire m_ready,
    output reg [WIDTH-1:0] m_data,
    output wire idle // it is empty
);
    // What comes while the output has to wait goes into the spare place.
    reg full;
    reg [WIDTH-1:0] spare;
    wire move = !m_valid | m_ready;
    assign s_ready = !full;
    assign idle = !m_valid & !full;
    always @(posedge clk) begin
        if (move) begin
            m_valid <= full | s_valid;
            m_data <= full ? spare : s_data;
            full <= 0;
        end else if (s_valid & !full) begin
            spare <= s_data;
            full <= 1;
        end
        if (rst) begin
            m_valid <= 0;
            full <= 0;
        end
    end

    generate
        if (WIDTH < 1) begin : range
            WIDTH_must_be_1_or_more stop ();
        end
    endgenerate

`ifdef FORMAL
    // Two numbers that count what came and went: the spare place has the one after the output's.
    reg begun = 0;
    reg [WIDTH-1:0] sent, received;
    always @(posedge clk) begin
        begun <= 1;
        if (!begun) assume (rst);
        assume (s_data == sent);
        sent <= rst ? 0 : sent + (s_valid & s_ready);
        received <= rst ? 0 : received + (m_valid & m_ready);
        if (begun) begin
            assert (m_valid | !full);
            assert (sent - received == {1'b0, m_valid} + {1'b0, full});
            if (m_valid) assert (m_data == received);
            if (full) assert (spare == received + 1'b1);
            assert (idle == (sent == received));
        end
    end
`endif
endmodule

`default_nettype wire

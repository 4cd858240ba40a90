// SPDX-License-Identifier: MIT
// The example in any Verilog simulator, waves in highlight_grey.vcd:
//   iverilog -g2005 -o highlight_grey -y rtl -y example example/highlight_grey_tb.v && vvp highlight_grey
// A line of cosines goes in, and its grey levels, of the library's F, come out while the taker makes it wait.
`default_nettype none
`timescale 1ns / 1ns

module highlight_grey_tb;
    localparam integer PIXELS = 11;
    reg clk = 0, rst = 1, in_valid = 0, out_ready = 0;
    wire in_ready, out_valid, out_last;
    wire [7:0] out_grey;
    integer sent = 0, received = 0, wrong = 0, clocks = 0;
    reg [17:0] cosine[0:PIXELS];
    reg [7:0] grey[0:PIXELS];

    highlight_grey dut (
        .clk(clk),
        .rst(rst),
        .in_valid(in_valid),
        .in_ready(in_ready),
        .in_cosine(cosine[sent]),
        .in_last(sent == PIXELS - 1),
        .out_valid(out_valid),
        .out_ready(out_ready),
        .out_grey(out_grey),
        .out_last(out_last)
    );

    always #20 clk = ~clk;

    initial begin
        // c, Q16.16, and 24 + 255 F(c), n = 60, at most 255
        cosine[0] = 18'd0;
        grey[0] = 8'd24;
        cosine[1] = 18'd40000;
        grey[1] = 8'd24;
        cosine[2] = 18'd47674;
        grey[2] = 8'd24;
        cosine[3] = 18'd47675;
        grey[3] = 8'd25;
        cosine[4] = 18'd55000;
        grey[4] = 8'd27;
        cosine[5] = 18'd60000;
        grey[5] = 8'd34;
        cosine[6] = 18'd62000;
        grey[6] = 8'd44;
        cosine[7] = 18'd63500;
        grey[7] = 8'd66;
        cosine[8] = 18'd64200;
        grey[8] = 8'd91;
        cosine[9] = 18'd65000;
        grey[9] = 8'd159;
        cosine[10] = 18'd65536;
        grey[10] = 8'd255;
        cosine[PIXELS] = 0;
        $dumpfile("highlight_grey.vcd");
        $dumpvars(0, highlight_grey_tb);
        repeat (3) @(negedge clk);
        rst = 0;
        // Inputs change at falling edges; what the rising edge takes is counted just before it.
        while (received < PIXELS && clocks < 1000) begin
            @(negedge clk);
            in_valid = sent < PIXELS && clocks % 5 != 0;
            out_ready = clocks % 3 != 0;
            clocks = clocks + 1;
            #19;
            if (out_valid && out_ready) begin
                if (out_grey !== grey[received] || out_last !== (received == PIXELS - 1)) begin
                    wrong = wrong + 1;
                    $display("pixel %0d is %0d, not %0d", received, out_grey, grey[received]);
                end
                received = received + 1;
            end
            if (in_valid && in_ready) begin
                @(posedge clk);
                #1 sent = sent + 1;
            end
        end
        $display("%0d pixels, %0d wrong", received, wrong);
        $finish;
    end
endmodule

`default_nettype wire

// SPDX-License-Identifier: MIT
// A Hazard3 core, set as the RP2350 has it, and memory without wait states where QEMU's machine virt has its own, so that the same programs
// run. +program=FILE: words in hex. A write to the serial port prints, one to the test device ends.
`default_nettype none
module top (
    input wire clk
);
    localparam WORDS = 524288; // from 80000000
    reg [31:0] memory[0:WORDS-1];
    reg [1023:0] program_file;
    initial if ($value$plusargs("program=%s", program_file)) $readmemh(program_file, memory);

    reg [3:0] started = 0;
    always @(posedge clk) if (!started[3]) started <= started + 1;

    wire [31:0] i_haddr, d_haddr, d_hwdata;
    wire [1:0] i_htrans, d_htrans;
    wire [2:0] d_hsize;
    wire d_hwrite;
    reg [31:0] i_hrdata, d_hrdata, d_at;
    reg [2:0] d_size;
    reg d_writes = 0;

    wire [18:0] d_word = d_at[20:2];
    wire [31:0] d_mask = d_size == 0 ? 32'hff << {d_at[1:0], 3'b0} : d_size == 1 ? 32'hffff << {d_at[1], 4'b0} : 32'hffffffff;
    wire [31:0] d_new = (memory[d_word] & ~d_mask) | (d_hwdata & d_mask);

    // Reads are answered in the cycle after their address, and see the write that is in its data phase.
    always @(posedge clk) begin
        if (i_htrans[1]) i_hrdata <= d_writes && d_at[31] && d_word == i_haddr[20:2] ? d_new : memory[i_haddr[20:2]];
        if (d_htrans[1]) d_hrdata <= d_writes && d_at[31] && d_word == d_haddr[20:2] ? d_new : memory[d_haddr[20:2]];
        if (d_writes && d_at[31]) memory[d_word] <= d_new;
        if (d_writes && d_at == 32'h10000000) begin
            $write("%c", d_hwdata[7:0]);
            if (d_hwdata[7:0] == 10) $fflush();
        end
        if (d_writes && d_at == 32'h00100000) $finish;
        d_writes <= d_htrans[1] && d_hwrite;
        d_at <= d_haddr;
        d_size <= d_hsize;
    end

    hazard3_cpu_2port #(
        .RESET_VECTOR(32'h80000000), .MTVEC_INIT(32'h80000000), .CSR_COUNTER(1), .U_MODE(1),
        .EXTENSION_ZBA(1), .EXTENSION_ZBB(1), .EXTENSION_ZBS(1), .EXTENSION_ZBKB(1), .EXTENSION_ZCB(1), .EXTENSION_ZCMP(1),
        .EXTENSION_ZIFENCEI(1), .EXTENSION_XH3BEXTM(1), .MULDIV_UNROLL(2), .MUL_FAST(1), .MUL_FASTER(1), .MULH_FAST(1),
        .FAST_BRANCHCMP(1), .BRANCH_PREDICTOR(1), .RESET_REGFILE(1)
    ) core (
        .clk(clk), .clk_always_on(clk), .rst_n(started[3]),
        .pwrup_req(), .pwrup_ack(1'b1), .clk_en(), .unblock_out(), .unblock_in(1'b0),
        .i_haddr(i_haddr), .i_hwrite(), .i_htrans(i_htrans), .i_hsize(), .i_hburst(), .i_hprot(), .i_hmastlock(), .i_hmaster(),
        .i_hready(1'b1), .i_hresp(1'b0), .i_hwdata(), .i_hrdata(i_hrdata),
        .d_haddr(d_haddr), .d_hwrite(d_hwrite), .d_htrans(d_htrans), .d_hsize(d_hsize), .d_hburst(), .d_hprot(), .d_hmastlock(),
        .d_hmaster(), .d_hexcl(), .d_hready(1'b1), .d_hresp(1'b0), .d_hexokay(1'b1), .d_hwdata(d_hwdata), .d_hrdata(d_hrdata),
        .dbg_req_halt(1'b0), .dbg_req_halt_on_reset(1'b0), .dbg_req_resume(1'b0), .dbg_halted(), .dbg_running(),
        .dbg_data0_rdata(32'b0), .dbg_data0_wdata(), .dbg_data0_wen(), .dbg_instr_data(32'b0), .dbg_instr_data_vld(1'b0),
        .dbg_instr_data_rdy(), .dbg_instr_caught_exception(), .dbg_instr_caught_ebreak(), .dbg_sbus_addr(32'b0), .dbg_sbus_write(1'b0),
        .dbg_sbus_size(2'b0), .dbg_sbus_vld(1'b0), .dbg_sbus_rdy(), .dbg_sbus_err(), .dbg_sbus_wdata(32'b0), .dbg_sbus_rdata(),
        .irq(1'b0), .soft_irq(1'b0), .timer_irq(1'b0)
    );
endmodule

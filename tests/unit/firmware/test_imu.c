/* SPDX-License-Identifier: MIT
 * The accelerometer's driver on a bus that answers, refuses, hangs and lies: what is written, when it is read, and what is told. */
#include <string.h>

#include "imu.h"
#include "unit.h"

/* ---- a device ---- */

static struct {
    uint8_t registers[256], address, pointer;
    uint8_t read[IMU_BYTES_MAX];
    uint32_t ends_us, now_us, number; /* of its sample */
    enum imu_transfer how;
    enum { WELL, ABSENT, REFUSES, HANGS, LIES, STICKS, SPINS, EMPTY, OFF } fault;
    unsigned transfers, stops, reads;
    bool is_busy;
} device;

enum { STATUS0 = 0x2e, AX_L = 0x35, BEGAN_US = 0xfff00000, TRANSFER_US = 250 };

/* Its clock is not ours: a period of 4.003 ms meets reads of 4 ms at every place. */
static uint32_t number_at(uint32_t now_us)
{
    return (now_us - BEGAN_US) / 4003;
}
static int16_t x_at(uint32_t now_us)
{
    return (int16_t)(-5 + (int)(number_at(now_us) % 11));
}

static void on_begin(void *context, uint8_t address, const uint8_t *bytes, size_t count, size_t wanted)
{
    (void)context;
    assert_false(device.is_busy);
    assert_true(count >= 1 && count <= 2 && wanted <= IMU_BYTES_MAX);
    device.is_busy = true;
    device.transfers++;
    device.ends_us = device.now_us + TRANSFER_US;
    device.how =
        address != device.address || device.fault == ABSENT || (device.fault == REFUSES && device.transfers % 2)
            ? IMU_FAILED
            : IMU_ENDED;
    if (device.how == IMU_FAILED)
        return;
    device.pointer = bytes[0];
    if (count == 2)
        device.registers[bytes[0]] = bytes[1];
    const bool counts_up = device.registers[0x02] & 0x40;
    for (size_t i = 0; i < wanted; i++)
        device.read[i] = device.fault == LIES ? 0xff
                         : device.fault == EMPTY && device.pointer > 0x30
                             ? 0
                             : device.registers[device.pointer + (counts_up ? i : 0)];
    device.reads += device.pointer == AX_L;
    if (device.pointer != AX_L)
        return;
    if (device.fault == WELL) /* a sample that comes in the middle of a read is mixed with the one before */
        device.read[1] = (uint8_t)((uint16_t)x_at(device.ends_us) >> 8);
    device.registers[STATUS0] = 0;
}

static enum imu_transfer on_ask(void *context, uint8_t *read)
{
    (void)context;
    assert_true(device.is_busy);
    if (device.fault == HANGS || (int32_t)(device.now_us - device.ends_us) < 0)
        return IMU_UNDER_WAY;
    device.is_busy = false;
    memcpy(read, device.read, sizeof device.read);
    return device.how;
}

static void on_stop(void *context)
{
    (void)context;
    assert_true(device.is_busy);
    device.is_busy = false;
    device.stops++;
}

static const struct imu_bus bus = {on_begin, on_ask, on_stop, NULL};
static struct imu imu;
static unsigned samples, losses;
static int16_t down; /* gravity */

static void put(unsigned axis, int16_t value)
{
    device.registers[AX_L + 2 * axis] = (uint8_t)value;
    device.registers[AX_L + 1 + 2 * axis] = (uint8_t)((uint16_t)value >> 8);
}

static void start(unsigned fault)
{
    memset(&device, 0, sizeof device);
    device.fault = fault;
    device.address = 0x6b;
    device.now_us = BEGAN_US; /* the clock wraps soon */
    imu = (struct imu){.bus = &bus};
    samples = losses = 0;
    device.registers[0] = 5;
    put(2, down = IMU_ONE_G);
}

static void run(unsigned ms)
{
    for (unsigned i = 0; i < ms * 20; i++, device.now_us += 50) {
        int16_t sample[3];
        if (device.fault != STICKS && device.fault != OFF)
            put(0, x_at(device.now_us));
        device.registers[STATUS0] |= number_at(device.now_us) != device.number && device.fault != OFF;
        device.number = number_at(device.now_us);
        put(1, device.fault == SPINS ? 32767 : -300);
        const enum imu_news news = imu_poll(&imu, device.now_us, sample);
        samples += news == IMU_SAMPLE;
        losses += news == IMU_LOST;
        if (news == IMU_SAMPLE && device.fault != SPINS && device.fault != OFF)
            assert_true(sample[0] >= -5 && sample[0] <= 5 && sample[1] == -300 && sample[2] == down);
    }
}

/* ---- tests ---- */

static void it_is_set_up_and_read_250_times_a_second_by_either_address(void **state)
{
    (void)state;
    for (unsigned other = 0; other < 2; other++) {
        start(WELL);
        device.address = other ? 0x6a : 0x6b;
        device.registers[0x06] = 0x77; /* its own filters */
        run(100);
        assert_true(device.registers[0x02] == 0x60 && device.registers[0x03] == 0x15 && device.registers[0x06] == 0 &&
                    device.registers[0x08] == 1);
        samples = 0;
        run(2000);
        assert_true(samples >= 490 && samples <= 501 && losses == 0);
    }
}

static void what_weighs_less_than_half_for_a_second_is_no_hand(void **state)
{
    (void)state;
    static const int16_t gravities[] = {IMU_ONE_G * 47 / 100, IMU_ONE_G * 53 / 100};
    for (unsigned i = 0; i < 2; i++) {
        start(WELL);
        run(100);
        put(2, down = gravities[i]);
        run(1500);
        assert_int_equal(losses, i == 0);
    }
}

static void a_sample_that_comes_in_the_middle_of_a_read_is_not_mixed_with_the_one_before(void **state)
{
    (void)state;
    start(WELL);
    run(20000); /* run() looks at each */
    assert_true(samples > 4900 && losses == 0);
}

static void one_that_is_not_there_or_is_another_is_told_once_and_found_when_it_comes(void **state)
{
    (void)state;
    for (unsigned fault = ABSENT; fault <= LIES; fault++) {
        start(fault);
        run(5000);
        assert_true(samples == 0 && losses == 1);
        assert_true(device.transfers < 200); /* it is not asked all the time */
        device.fault = WELL;
        run(1500);
        assert_true(samples > 50 && losses == 1);
    }
}

static void a_transfer_that_never_ends_is_given_up_within_two_milliseconds(void **state)
{
    (void)state;
    start(WELL);
    run(100);
    assert_true(samples > 10);
    device.fault = HANGS;
    run(7);
    assert_true(device.stops >= 1);
    run(100);
    assert_int_equal(losses, 1);
    run(3000);
    assert_int_equal(losses, 1);
    device.fault = WELL;
    samples = 0;
    run(1500);
    assert_true(samples > 50 && losses == 1);
}

static void a_refusal_now_and_then_is_overlooked(void **state)
{
    (void)state;
    start(WELL);
    run(100);
    device.fault = REFUSES; /* every other transfer */
    samples = 0;
    run(1000);
    assert_true(samples > 60 && losses == 0);
}

/* As a part in distress needs, and another on its bus. */
static void after_a_refusal_the_bus_rests_for_a_period(void **state)
{
    (void)state;
    start(WELL);
    run(100);
    device.fault = ABSENT;
    device.transfers = 0;
    run(3); /* less than a period */
    assert_in_range(device.transfers, 0, 1);
    run(10);
    assert_in_range(device.transfers, 1, 4);
}

static void what_no_hand_does_for_a_second_and_samples_that_never_change_are_told(void **state)
{
    (void)state;
    for (unsigned fault = STICKS; fault <= SPINS; fault++) {
        start(WELL);
        run(200);
        device.fault = fault;
        run(900);
        assert_int_equal(losses, 0);
        run(3000);
        assert_int_equal(losses, 1); /* it answers all the while, but is not back */
        device.fault = WELL;
        samples = 0;
        run(1500);
        assert_true(samples > 50);
        device.fault = ABSENT;
        run(1000);
        assert_int_equal(losses, 2);
    }
}

/* Its data sheets say 15 ms, 150 ms and 1.75 s, by their age. */
static void one_that_needs_1_75_seconds_after_power_up_is_not_told_as_lost(void **state)
{
    (void)state;
    start(ABSENT);
    run(1750);
    device.fault = WELL;
    run(500);
    assert_true(samples > 10 && losses == 0);
}

/* The board was restarted in the middle of a byte: the first transfer hangs, and the bus is free after nine clocks. */
static void a_bus_that_is_held_at_first_is_freed_and_not_told(void **state)
{
    (void)state;
    start(HANGS);
    while (device.stops == 0)
        run(1);
    device.fault = WELL;
    run(500);
    assert_true(samples > 10 && losses == 0);
}

/* Until its first sample a part that was just turned on answers with what lies in its registers. */
static void what_is_read_before_the_first_sample_is_no_sample(void **state)
{
    (void)state;
    start(EMPTY);
    run(15);
    assert_true(device.registers[0x08] == 1 && samples == 0);
    device.fault = WELL;
    run(100);
    assert_true(samples > 20 && losses == 0);
}

/* It has lost its supply, answers again, and is as after power-up: off, and its addresses do not count up. */
static void one_that_has_reset_itself_is_set_up_again(void **state)
{
    (void)state;
    start(WELL);
    run(100);
    memset(&device.registers[1], 0, 0x34);
    device.fault = OFF;
    run(1200);
    device.fault = WELL;
    samples = 0;
    run(2000);
    assert_true(device.registers[0x02] == 0x60 && device.registers[0x08] == 1 && samples > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_set_up_and_read_250_times_a_second_by_either_address),
        cmocka_unit_test(a_sample_that_comes_in_the_middle_of_a_read_is_not_mixed_with_the_one_before),
        cmocka_unit_test(one_that_is_not_there_or_is_another_is_told_once_and_found_when_it_comes),
        cmocka_unit_test(a_transfer_that_never_ends_is_given_up_within_two_milliseconds),
        cmocka_unit_test(a_refusal_now_and_then_is_overlooked),
        cmocka_unit_test(after_a_refusal_the_bus_rests_for_a_period),
        cmocka_unit_test(what_no_hand_does_for_a_second_and_samples_that_never_change_are_told),
        cmocka_unit_test(one_that_needs_1_75_seconds_after_power_up_is_not_told_as_lost),
        cmocka_unit_test(a_bus_that_is_held_at_first_is_freed_and_not_told),
        cmocka_unit_test(what_is_read_before_the_first_sample_is_no_sample),
        cmocka_unit_test(one_that_has_reset_itself_is_set_up_again),
        cmocka_unit_test(what_weighs_less_than_half_for_a_second_is_no_hand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

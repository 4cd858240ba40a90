/* SPDX-License-Identifier: MIT
 * FunctionFS: this thread answers control requests; another reads bulk bytes, as a read of the endpoint blocks. */
#include <endian.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/usb/functionfs.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include "configfs.h"
#include "functionfs.h"
#include "message.h"

enum {
    CHUNK_BYTES = 32768,   /* of a read; a multiple of every packet size */
    GRACE_MS = 50,         /* for bulk bytes that are under way when the next request arrives */
    READS_UNDER_WAY = 128, /* of these at most: a host may send a few bytes at a time, and go on */
    REPLUG_MS = 1000,      /* how often to look for a controller that went away */
    INTERRUPT = SIGUSR2    /* ends a read */
};

static const struct usb_function *function;
static bool verbose;
static int control, bulk_out, signals;

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t work = PTHREAD_COND_INITIALIZER; /* the bulk thread waits for it */
static pthread_cond_t progress;                        /* the control thread waits for the bulk thread */
static pthread_t bulk_thread;
static bool configured, ending, reading, stopping;
/* A read failed: nothing is read until the next rectangle, or until the host configures the device. */
static bool broken;
static unsigned long reads; /* finished */

static sigset_t end_signals; /* the signals that end the program */
static volatile sig_atomic_t is_to_end;

/* ---- descriptors ---- */

#define INTERFACE                                                                                                      \
    {                                                                                                                  \
        .bLength = sizeof(struct usb_interface_descriptor), .bDescriptorType = USB_DT_INTERFACE, .bNumEndpoints = 1,   \
        .bInterfaceClass = GUD_INTERFACE_CLASS, .iInterface = 1                                                        \
    }
#define BULK_OUT(bytes)                                                                                                \
    {                                                                                                                  \
        .bLength = sizeof(struct usb_endpoint_descriptor_no_audio), .bDescriptorType = USB_DT_ENDPOINT,                \
        .bEndpointAddress = 1 | USB_DIR_OUT, .bmAttributes = USB_ENDPOINT_XFER_BULK, .wMaxPacketSize = htole16(bytes)  \
    }

struct speed {
    struct usb_interface_descriptor interface;
    struct usb_endpoint_descriptor_no_audio out;
} __attribute__((packed));

static void write_descriptors(void)
{
    const struct {
        struct usb_functionfs_descs_head_v2 head;
        __le32 full_count, high_count, super_count;
        struct speed full, high, super;
        struct usb_ss_ep_comp_descriptor companion;
    } __attribute__((packed)) descriptors = {
        .head = {.magic = htole32(FUNCTIONFS_DESCRIPTORS_MAGIC_V2),
                 .length = htole32(sizeof descriptors),
                 .flags = htole32(FUNCTIONFS_HAS_FS_DESC | FUNCTIONFS_HAS_HS_DESC | FUNCTIONFS_HAS_SS_DESC)},
        .full_count = htole32(2),
        .high_count = htole32(2),
        .super_count = htole32(3),
        .full = {INTERFACE, BULK_OUT(64)},
        .high = {INTERFACE, BULK_OUT(512)},
        .super = {INTERFACE, BULK_OUT(1024)},
        .companion = {.bLength = sizeof(struct usb_ss_ep_comp_descriptor), .bDescriptorType = USB_DT_SS_ENDPOINT_COMP}};
    const struct {
        struct usb_functionfs_strings_head head;
        __le16 language;
        char text[sizeof "display"];
    } __attribute__((packed)) strings = {.head = {.magic = htole32(FUNCTIONFS_STRINGS_MAGIC),
                                                  .length = htole32(sizeof strings),
                                                  .str_count = htole32(1),
                                                  .lang_count = htole32(1)},
                                         .language = htole16(0x409),
                                         .text = "display"};
    if (write(control, &descriptors, sizeof descriptors) != (ssize_t)sizeof descriptors ||
        write(control, &strings, sizeof strings) != (ssize_t)sizeof strings)
        fail("FunctionFS refuses the descriptors: %s", strerror(errno));
}

/* ---- bulk ---- */

/* A read ends with a short packet or when it is full. It takes whole packets, so that a packet that is too long has room, and
 * no more of them than the rectangle needs: no short packet follows a rectangle that ends with a full one. */
static size_t read_bytes(uint32_t expected)
{
    struct usb_endpoint_descriptor endpoint;
    size_t packet = 64;
    if (ioctl(bulk_out, FUNCTIONFS_ENDPOINT_DESC, &endpoint) == 0 && le16toh(endpoint.wMaxPacketSize))
        packet = le16toh(endpoint.wMaxPacketSize);
    const size_t bytes = (expected + packet - 1) / packet * packet;
    return bytes < CHUNK_BYTES ? bytes : CHUNK_BYTES;
}

static void *bulk_loop(void *nothing)
{
    static uint8_t chunk[CHUNK_BYTES];
    pthread_mutex_lock(&lock);
    while (!ending) {
        const uint32_t expected = configured && !stopping && !broken ? function->expects(function->context) : 0;
        if (expected == 0) {
            pthread_cond_wait(&work, &lock);
            continue;
        }
        reading = true;
        pthread_mutex_unlock(&lock);
        const ssize_t count = read(bulk_out, chunk, read_bytes(expected));
        const int error = errno;
        pthread_mutex_lock(&lock);
        reading = false;
        reads++;
        if (count > 0)
            function->bulk(function->context, chunk, (size_t)count);
        else if (count < 0 && error != EINTR)
            broken = true;
        pthread_cond_broadcast(&progress);
    }
    pthread_mutex_unlock(&lock);
    return nothing;
}

/* By the clock that is never set: boards without a battery get the time from the network, after a while. */
static void begin_progress(void)
{
    pthread_condattr_t attributes;
    pthread_condattr_init(&attributes);
    pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
    pthread_cond_init(&progress, &attributes);
    pthread_condattr_destroy(&attributes);
}

static void wait_progress(long ms)
{
    struct timespec until;
    clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_nsec += ms * 1000000;
    if (until.tv_nsec >= 1000000000) {
        until.tv_nsec -= 1000000000;
        until.tv_sec++;
    }
    pthread_cond_timedwait(&progress, &lock, &until);
}

/* A host may ask for the next rectangle as soon as the controller has the last byte of this one, so this waits for bytes that
 * are under way: 4 MB at most. */
static void let_bulk_arrive(void)
{
    unsigned long before = reads - 1;
    for (unsigned i = 0;
         i < READS_UNDER_WAY && configured && !broken && before != reads && function->expects(function->context); i++) {
        before = reads;
        wait_progress(GRACE_MS);
    }
}

/* Ends a read whose bytes never came. The caller holds the lock. The signal may arrive before the read has begun, so it is
 * sent again; `stopping` keeps another read from beginning for the rectangle that is given up. */
static void stop_reading(void)
{
    stopping = true;
    while (reading) {
        pthread_kill(bulk_thread, INTERRUPT);
        wait_progress(1);
    }
    stopping = false;
    pthread_cond_signal(&work);
}

void functionfs_halt(void)
{
    if (write(bulk_out, "", 1) >= 0 || errno != EBADMSG) /* FunctionFS stalls on I/O in the wrong direction */
        warn("the endpoint cannot be stalled: %s", strerror(errno));
}

/* ---- control ---- */

/* The same for a request. */
static void stall(bool in)
{
    char none;
    const ssize_t result = in ? read(control, &none, 0) : write(control, &none, 0);
    if (result < 0 && errno != EL2HLT && errno != EIDRM)
        warn("a request cannot be refused: %s", strerror(errno));
}

static void end(int number)
{
    (void)number;
    is_to_end = true;
    alarm(1); /* the signal may have come just before the transfer began to wait */
}

/* The data of a request, which wait for the host: for ever where it has given up, so signals end that, too. Stopped and continued, it waits
 * again, since FunctionFS takes nothing else before. */
static ssize_t transfer(bool in, uint8_t *data, size_t count)
{
    ssize_t result = -1;
    errno = EINTR;
    pthread_sigmask(SIG_UNBLOCK, &end_signals, NULL);
    while (result < 0 && errno == EINTR && !is_to_end)
        result = in ? write(control, data, count) : read(control, data, count);
    const int error = errno;
    pthread_sigmask(SIG_BLOCK, &end_signals, NULL);
    alarm(0);
    errno = error;
    return result;
}

static void answer(const struct usb_ctrlrequest *request)
{
    const struct gud_setup setup = {.type = request->bRequestType,
                                    .request = request->bRequest,
                                    .value = le16toh(request->wValue),
                                    .index = le16toh(request->wIndex),
                                    .length = le16toh(request->wLength)};
    const bool in = setup.type & USB_DIR_IN;
    uint8_t reply[GUD_REPLY_BYTES], data[GUD_DATA_BYTES];
    pthread_mutex_lock(&lock);
    if (!in && setup.request == GUD_SET_BUFFER) {
        let_bulk_arrive();
        stop_reading();
        broken = false;
    }
    const int length = function->setup(function->context, &setup, reply);
    pthread_mutex_unlock(&lock);
    if (verbose)
        fprintf(stderr, "request %02x %02x value %u index %u length %u: %d\n", setup.type, setup.request, setup.value,
                setup.index, setup.length, length);
    if (length < 0) {
        stall(in);
        return;
    }
    if (in) {
        if (transfer(in, reply, (size_t)length) < 0 && errno != EIDRM && errno != ESHUTDOWN && errno != EINTR)
            warn("request %02x cannot be answered: %s", setup.request, strerror(errno));
        return;
    }
    if (transfer(in, data, (size_t)length) != length)
        return; /* the host sent another request, or left */
    pthread_mutex_lock(&lock);
    const bool good = function->set(function->context, &setup, data);
    pthread_cond_signal(&work);
    pthread_mutex_unlock(&lock);
    if (verbose && !good)
        fprintf(stderr, "request %02x: its values are refused\n", setup.request);
}

static void take_event(const struct usb_functionfs_event *event)
{
    static const char *const names[] = {"bound", "unbound", "enabled", "disabled", "", "suspended", "resumed"};
    if (event->type == FUNCTIONFS_SETUP) {
        answer(&event->u.setup);
        return;
    }
    if (verbose && event->type <= FUNCTIONFS_RESUME)
        fprintf(stderr, "%s\n", names[event->type]);
    pthread_mutex_lock(&lock);
    switch (event->type) {
    case FUNCTIONFS_ENABLE:
    case FUNCTIONFS_DISABLE:
    case FUNCTIONFS_UNBIND:
        configured = false;
        stop_reading();
        broken = false;
        function->event(function->context, USB_RESET);
        configured = event->type == FUNCTIONFS_ENABLE;
        pthread_cond_signal(&work);
        break;
    case FUNCTIONFS_SUSPEND:
        function->event(function->context, USB_SUSPEND);
        break;
    case FUNCTIONFS_RESUME:
        function->event(function->context, USB_RESUME);
        break;
    }
    pthread_mutex_unlock(&lock);
}

static void take_events(void)
{
    struct usb_functionfs_event events[4];
    const ssize_t bytes = read(control, events, sizeof events);
    if (bytes < 0 && errno != EIDRM && errno != EINTR && errno != EAGAIN)
        fail("FunctionFS: %s", strerror(errno));
    for (ssize_t i = 0; i < bytes / (ssize_t)sizeof *events; i++)
        take_event(&events[i]);
}

/* ---- the whole ---- */

static void ignore(int number)
{
    (void)number;
}

void functionfs_hold_signals(void)
{
    static const int numbers[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGALRM};
    const struct sigaction ended = {.sa_handler = end}; /* without SA_RESTART, as below */
    sigemptyset(&end_signals);
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        sigaddset(&end_signals, numbers[i]);
        sigaction(numbers[i], &ended, NULL);
    }
    sigset_t set = end_signals;
    sigaddset(&set, SIGUSR1);
    pthread_sigmask(SIG_BLOCK, &set, NULL);
    const struct sigaction interrupt = {.sa_handler = ignore}; /* without SA_RESTART: the read returns */
    sigaction(INTERRUPT, &interrupt, NULL);
    signal(SIGPIPE, SIG_IGN); /* without a reader of the messages it goes on, and takes the gadget down at the end */
    signals = signalfd(-1, &set, SFD_CLOEXEC);
}

static int open_endpoint(const char *folder, const char *name, int flags)
{
    char path[300];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    const int file = open(path, flags | O_CLOEXEC);
    if (file < 0)
        fail("%s: %s", path, strerror(errno));
    return file;
}

static void serve(void (*dump)(void *context))
{
    struct pollfd files[] = {{.fd = control, .events = POLLIN}, {.fd = signals, .events = POLLIN}};
    while (!is_to_end) {
        const int ready = poll(files, 2, REPLUG_MS);
        if (ready < 0)
            continue; /* interrupted: revents are stale */
        if (ready == 0 && configfs_is_lost())
            configfs_plug();
        if (files[0].revents & (POLLIN | POLLHUP | POLLERR))
            take_events();
        if (!is_to_end && files[1].revents & POLLIN) { /* what ended a transfer is gone */
            struct signalfd_siginfo signal;
            if (read(signals, &signal, sizeof signal) == (ssize_t)sizeof signal && signal.ssi_signo != SIGUSR1)
                return;
            pthread_mutex_lock(&lock);
            let_bulk_arrive();
            dump(function->context);
            pthread_mutex_unlock(&lock);
        }
    }
}

void functionfs_run(const char *folder, const struct usb_function *run, bool tell, void (*dump)(void *context))
{
    function = run;
    verbose = tell;
    begin_progress();
    control = open_endpoint(folder, "ep0", O_RDWR);
    write_descriptors();
    fcntl(control, F_SETFL,
          O_NONBLOCK); /* events may be gone after poll; a request's data are waited for all the same */
    bulk_out = open_endpoint(folder, "ep1", O_RDWR);
    const int error = pthread_create(&bulk_thread, NULL, bulk_loop, NULL);
    if (error)
        fail("no thread for the bulk endpoint: %s", strerror(error));
    if (!configfs_plug())
        fail("%s: does not take the gadget: %s", configfs_udc(), strerror(errno));
    printf("glint-gadget: on the bus, %s\n", configfs_udc());
    fflush(stdout);
    serve(dump);
    pthread_mutex_lock(&lock);
    let_bulk_arrive(); /* the last picture is whole where it can be */
    ending = true;
    stop_reading();
    pthread_mutex_unlock(&lock);
    pthread_join(bulk_thread, NULL);
    configfs_unplug();
    close(bulk_out);
    close(control);
}

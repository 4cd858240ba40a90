/* SPDX-License-Identifier: MIT
 * The functions and objects of ISO C, those of POSIX in headers that most programs include, and those that gcc and clang know
 * without a header and refuse as the name of anything else. */
#include "base/c_library.h"

#include <string.h>

/* Each also with the suffixes below. */
static const char families[] =
    " acos acosh asin asinh atan atan2 atanh cabs cacos cacosh carg casin casinh catan catanh cbrt ccos ccosh ceil "
    "cexp cimag clog clog10 conj copysign cos cosh cpow cproj creal csin csinh csqrt ctan ctanh drem erf erfc exp "
    "exp10 exp2 expm1 fabs fdim finite floor fma fmax fmin fmod frexp gamma hypot ilogb isinf isnan j0 j1 jn "
    "ldexp lgamma llrint llround log log10 log1p log2 logb lrint lround modf nan nearbyint nextafter nexttoward "
    "pow pow10 remainder remquo rint round roundeven scalb scalbln scalbn signbit significand sin sincos sinh sqrt tan "
    "tanh tgamma trunc y0 y1 yn ";
static const char *const suffixes[] = {"f",    "l",    "f16",   "f32", "f64", "f128",
                                       "f32x", "f64x", "f128x", "d32", "d64", "d128"};

static const char words[] =
    " a64l abort abs access alarm aligned_alloc alloca asctime at_quick_exit atexit atof atoi atol atoll bcmp "
    "bcopy bsearch btowc bzero c16rtomb c32rtomb call_once calloc chdir chmod chown clearerr clock "
    "clock_getcpuclockid clock_getres clock_gettime clock_nanosleep clock_settime close confstr creat ctermid "
    "ctime daylight dcgettext dgettext difftime div dprintf drand48 dup dup2 duplocale erand48 execl execle "
    "execlp execv execve execvp exit faccessat fchdir fchmod fchmodat fchown fchownat fclose fcntl fdatasync "
    "fdopen feclearexcept fegetenv fegetexceptflag fegetround feholdexcept feof feraiseexcept ferror fesetenv "
    "fesetexceptflag fesetround fetestexcept feupdateenv fexecve fflush ffs ffsimax ffsl ffsll fgetc fgetpos fgets "
    "fgetwc "
    "fgetws fileno flockfile fmemopen fopen fork fpathconf fprintf fputc fputs fputwc fputws fread free "
    "freelocale freopen fscanf fseek fseeko fsetpos fstat fstatat fsync ftell ftello ftruncate ftrylockfile "
    "funlockfile futimens fwide fwprintf fwrite fwscanf getc getchar getcwd getdate getdate_err getdelim getegid "
    "getenv geteuid getgid getgroups gethostid gethostname getline getlogin getopt getpgid getpgrp getpid getppid "
    "getsid getsubopt gettext getuid getwc getwchar gmtime grantpt imaxabs imaxdiv index initstate isalnum "
    "isalpha isascii isatty isblank iscntrl isdigit isgraph islower isprint ispunct isspace isupper iswalnum "
    "iswalpha iswblank iswcntrl iswctype iswdigit iswgraph iswlower iswprint iswpunct iswspace iswupper iswxdigit "
    "isxdigit jrand48 kill killpg l64a labs lchown lcong48 ldiv link linkat llabs lldiv localeconv localtime "
    "lockf longjmp lrand48 lseek lstat malloc mblen mbrlen mbrtoc16 mbrtoc32 mbrtowc mbsinit mbsnrtowcs mbsrtowcs "
    "mbstowcs mbtowc memalign memccpy memchr memcmp memcpy memmove mempcpy memset mkdir mkdirat mkdtemp mkfifo "
    "mkfifoat mknod mknodat mkstemp mktime mrand48 nanosleep newlocale nice nrand48 open open_memstream "
    "open_wmemstream openat optarg opterr optind optopt pathconf pause pclose perror pipe popen posix_fadvise "
    "posix_fallocate posix_memalign posix_openpt pread printf psiginfo psignal ptsname putc putchar putenv puts "
    "putwc putwchar pwrite qsort quick_exit raise rand random read readlink readlinkat realloc realpath remove "
    "rename renameat rewind rindex rmdir scanf seed48 setbuf setegid setenv seteuid setgid setjmp setlocale "
    "setpgid setpgrp setregid setreuid setsid setstate setuid setvbuf sigaction sigaddset sigaltstack sigdelset "
    "sigemptyset sigfillset sighold sigignore siginterrupt sigismember siglongjmp signal signgam sigpause "
    "sigpending sigprocmask sigqueue sigrelse sigset sigsuspend sigtimedwait sigwait sigwaitinfo sleep snprintf "
    "sprintf srand srand48 srandom sscanf stat stderr stdin stdout stpcpy stpncpy strcasecmp strcat strchr strcmp "
    "strcoll strcpy strcspn strdup strerror strfmon strftime strlen strncasecmp strncat strncmp strncpy strndup "
    "strnlen strpbrk strptime strrchr strsignal strspn strstr strtod strtof strtoimax strtok strtol strtold "
    "strtoll strtoul strtoull strtoumax strxfrm swab swprintf swscanf symlink symlinkat sync sysconf system "
    "tcgetpgrp tcsetpgrp tempnam time timer_create timer_delete timer_getoverrun timer_gettime timer_settime "
    "timespec_get timezone tmpfile tmpnam toascii tolower toupper towctrans towlower towupper truncate ttyname "
    "tzname tzset umask ungetc ungetwc unlink unlinkat unlockpt unsetenv uselocale utimensat va_copy va_end "
    "va_start vdprintf vfork vfprintf vfscanf vfwprintf vfwscanf vprintf vscanf vsnprintf vsprintf vsscanf "
    "vswprintf vswscanf vwprintf vwscanf wcpcpy wcpncpy wcrtomb wcscasecmp wcscat wcschr wcscmp wcscoll wcscpy "
    "wcscspn wcsdup wcsftime wcslen wcsncasecmp wcsncat wcsncmp wcsncpy wcsnlen wcsnrtombs wcspbrk wcsrchr "
    "wcsrtombs wcsspn wcsstr wcstod wcstof wcstoimax wcstok wcstol wcstold wcstoll wcstombs wcstoul wcstoull "
    "wcstoumax wcswcs wcswidth wcsxfrm wctob wctomb wctrans wctype wcwidth wmemchr wmemcmp wmemcpy wmemmove "
    "wmemset wprintf write wscanf ";
static const char *const variants[] = {"_l", "_r", "_unlocked"};

static const char *const beginnings[] = {"atomic_", "cnd_", "mtx_", "pthread_", "thrd_", "tss_"};

static bool among(const char *list, const char *text, size_t length)
{
    for (const char *at = list; length && *at; at += strcspn(at, " ")) {
        at += strspn(at, " ");
        if (strcspn(at, " ") == length && memcmp(at, text, length) == 0)
            return true;
    }
    return false;
}

/* How long the text is without this ending; 0 where it does not have it. */
static size_t before(const char *ending, const char *text, size_t length)
{
    const size_t end = strlen(ending);
    return length > end && memcmp(text + length - end, ending, end) == 0 ? length - end : 0;
}

static bool is_known(const char *text, size_t length)
{
    if (among(families, text, length) || among(words, text, length))
        return true;
    for (size_t i = 0; i < sizeof suffixes / sizeof *suffixes; i++)
        if (among(families, text, before(suffixes[i], text, length)))
            return true;
    return false;
}

bool is_c_library_name(const char *text)
{
    const size_t length = strlen(text);
    for (size_t i = 0; i < sizeof beginnings / sizeof *beginnings; i++)
        if (strncmp(text, beginnings[i], strlen(beginnings[i])) == 0)
            return true;
    for (size_t i = 0; i < sizeof variants / sizeof *variants; i++)
        if (is_known(text, before(variants[i], text, length)))
            return true;
    return is_known(text, length);
}

/* Preloaded into one program: the n-th call of a kind fails, as on a full or broken disk, or without memory.
 *
 * FAIL_PROGRAM  name of the program that it acts in; in others it only passes calls on
 * FAIL_CALL     write, fsync, rename, open (for writing), mkdir or malloc
 * FAIL_AT       which call fails, from 1; 0: none
 * FAIL_ERRNO    what it fails with
 * FAIL_REPORT   file that takes one byte when the call has failed
 */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

static const char *wanted;
static long fail_at;
static int fail_errno;
static atomic_long calls;

__attribute__((constructor)) static void read_orders(void) {
  const char *program = getenv("FAIL_PROGRAM"), *at = getenv("FAIL_AT"), *number = getenv("FAIL_ERRNO");
  if (!program || strcmp(program, program_invocation_short_name) != 0) return;
  fail_at = at ? atol(at) : 0;
  fail_errno = number ? atoi(number) : EIO;
  wanted = getenv("FAIL_CALL");
}

static int fails(const char *call) {
  if (!wanted || strcmp(wanted, call) != 0 || atomic_fetch_add(&calls, 1) + 1 != fail_at) return 0;
  const char *report = getenv("FAIL_REPORT");
  int file = report ? (int)syscall(SYS_openat, AT_FDCWD, report, O_WRONLY | O_CREAT, 0600) : -1;
  if (file >= 0) {
    syscall(SYS_write, file, "x", 1);
    syscall(SYS_close, file);
  }
  errno = fail_errno;
  return 1;
}

ssize_t write(int file, const void *data, size_t size) {
  return file > 2 && fails("write") ? -1 : syscall(SYS_write, file, data, size);
}

ssize_t writev(int file, const struct iovec *parts, int count) {
  return file > 2 && fails("write") ? -1 : syscall(SYS_writev, file, parts, count);
}

int fsync(int file) { return fails("fsync") ? -1 : (int)syscall(SYS_fsync, file); }

int rename(const char *from, const char *to) { return fails("rename") ? -1 : (int)syscall(SYS_rename, from, to); }

int mkdir(const char *path, mode_t mode) { return fails("mkdir") ? -1 : (int)syscall(SYS_mkdir, path, mode); }

static int opened(const char *path, int flags, mode_t mode) {
  if ((flags & O_ACCMODE) != O_RDONLY && fails("open")) return -1;
  return (int)syscall(SYS_openat, AT_FDCWD, path, flags, mode);
}

int open(const char *path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  mode_t mode = flags & O_CREAT ? va_arg(more, mode_t) : 0;
  va_end(more);
  return opened(path, flags, mode);
}

int open64(const char *path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  mode_t mode = flags & O_CREAT ? va_arg(more, mode_t) : 0;
  va_end(more);
  return opened(path, flags, mode);
}

extern void *__libc_malloc(size_t);
extern void *__libc_calloc(size_t, size_t);
extern void *__libc_realloc(void *, size_t);

void *malloc(size_t size) { return fails("malloc") ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return fails("malloc") ? NULL : __libc_calloc(count, size); }
void *realloc(void *old, size_t size) { return fails("malloc") ? NULL : __libc_realloc(old, size); }

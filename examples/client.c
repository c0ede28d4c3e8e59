/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Finds the separation at which a train can grow by GROWTH, in a line-by-line dialogue with the program
 * domino. client.py does the same in Python.
 *
 *   cc client.c -o client
 */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static FILE *to, *from; /* the two pipes */

/* Starts the program with a pipe at each end.  Returns its process, or -1. */
static pid_t start(void)
{
    int in[2], out[2];
    if (pipe(in) != 0 || pipe(out) != 0)
        return -1;
    pid_t child = fork();
    if (child == 0) {
        dup2(in[0], STDIN_FILENO);
        dup2(out[1], STDOUT_FILENO);
        close(in[1]); /* otherwise the program would never see the end of its input */
        execlp("domino", "domino", (char *)NULL);
        _exit(127);
    }
    close(in[0]);
    close(out[1]);
    to = fdopen(in[1], "w");
    from = fdopen(out[0], "r");
    return to && from ? child : -1;
}

/* Asks one question and returns the number with this key in the answer, which is a JSON object. Ends this
 * program if there is no such number. */
static double ask(const char *question, const char *key)
{
    char answer[4096], name[64];
    fprintf(to, "%s\n", question);
    fflush(to); /* otherwise the question would wait in the buffer */
    if (!fgets(answer, sizeof answer, from)) {
        fprintf(stderr, "client: no answer; is domino installed?\n");
        exit(1);
    }
    snprintf(name, sizeof name, "\"%s\":", key);
    const char *value = strstr(answer, name);
    if (!value) { /* after an error, the object holds the message instead */
        fprintf(stderr, "client: no %s in %s", key, answer);
        exit(1);
    }
    return strtod(value + strlen(name), NULL);
}

int main(int argc, char **argv)
{
    char question[256];
    signal(SIGPIPE, SIG_IGN);
    if (argc != 2) {
        fprintf(stderr, "usage: client GROWTH\n");
        return 2;
    }
    pid_t child = start();
    if (child < 0) {
        perror("client");
        return 1;
    }
    fprintf(to, "set output json\n"); /* no answer, because the output is not yet json */
    snprintf(question, sizeof question, "print %s", argv[1]);
    double growth = ask(question, "value");
    double low = 0.001, high = ask("best", "s"); /* up to `high`, the largest growth increases with s */
    for (int i = 0; i < 40; i++) {
        double middle = (low + high) / 2;
        snprintf(question, sizeof question, "rmax %.17g", middle);
        if (ask(question, "r_max") < growth)
            low = middle;
        else
            high = middle;
    }
    printf("%.9g\n", high);
    fclose(to);
    waitpid(child, NULL, 0);
    return 0;
}

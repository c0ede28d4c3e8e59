/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * The separation at which a train can grow by GROWTH: a dialogue with the program domino, line by line, as
 * client.py has it.
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
        close(in[1]); /* else the program would wait for its own end of the pipe */
        execlp("domino", "domino", (char *)NULL);
        _exit(127);
    }
    close(in[0]);
    close(out[1]);
    to = fdopen(in[1], "w");
    from = fdopen(out[0], "r");
    return to && from ? child : -1;
}

/* Asks one question, and finds a number in the object that answers it; ends the program where none is. */
static double ask(const char *question, const char *key)
{
    char answer[4096], name[64];
    fprintf(to, "%s\n", question);
    fflush(to); /* the program cannot answer what it has not got */
    if (!fgets(answer, sizeof answer, from)) {
        fprintf(stderr, "client: no answer; is domino installed?\n");
        exit(1);
    }
    snprintf(name, sizeof name, "\"%s\":", key);
    const char *value = strstr(answer, name);
    if (!value) { /* the object of an error says what is wrong */
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
    fprintf(to, "set output json\n"); /* answers nothing: the output is not json before it */
    snprintf(question, sizeof question, "print %s", argv[1]);
    double growth = ask(question, "value");
    double low = 0.001, high = ask("best", "s"); /* up to there the largest growth increases with s */
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

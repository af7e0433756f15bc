// What every timing program in C++ does on its pipe: it answers, or measures. A line in, a line of JSON out.
//
//   list                           {"CONTESTANT": [works]}
//   answer CONTESTANT WORK STATE   {"part": [numbers], ...}
//   time CONTESTANT WORK PASSES    nanoseconds a state; of each few states the least of so many passes counts
//   cold CONTESTANT WORK           [nanoseconds, a number a state], each call with nothing in the first two caches
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

[[noreturn]] inline void fail(const std::string &message)
{
    std::fprintf(stderr, "%s\n", message.c_str());
    std::exit(2);
}

// Name and numbers of a part of an answer, matrices by columns.
using Parts = std::vector<std::pair<std::string, std::vector<double>>>;

struct Work
{
    std::string name;
    std::function<void(std::size_t)> call;    // what is timed, at a state
    std::function<Parts(std::size_t)> answer; // what it gives there; not timed
};

// States that are timed together: a disturbance hits some of them, not all.
constexpr std::size_t TOGETHER = 32;

// States at which cold calls are timed.
constexpr std::size_t COLD_STATES = 16;

// Twice the second cache of a large processor.
constexpr std::size_t WALKED_BYTES = std::size_t(16) << 20;

class Server
{
  public:
    Server(std::string contestant, std::size_t states, std::vector<Work> works)
        : contestant(std::move(contestant)), states(states), works(std::move(works)), walked(WALKED_BYTES / 8)
    {
    }

    void serve()
    {
        for (std::string what, name; std::cin >> what;)
        {
            if (what == "list")
                list();
            else if (std::cin >> name >> name; what == "answer")
                answer(find(name));
            else if (what == "time")
                time(find(name));
            else if (what == "cold")
                cold(find(name));
            else
                fail("unknown request " + what);
            std::fflush(stdout);
        }
    }

  private:
    std::string contestant;
    std::size_t states;
    std::vector<Work> works;
    std::vector<double> walked;

    const Work &find(const std::string &name) const
    {
        for (const auto &work : works)
            if (work.name == name) return work;
        fail("unknown work " + name);
    }

    void list() const
    {
        std::printf("{\"%s\": [", contestant.c_str());
        for (std::size_t i = 0; i < works.size(); ++i) std::printf("%s\"%s\"", i ? ", " : "", works[i].name.c_str());
        std::puts("]}");
    }

    static void numbers(const std::vector<double> &values)
    {
        std::fputs("[", stdout);
        for (std::size_t i = 0; i < values.size(); ++i) std::printf("%s%.17g", i ? "," : "", values[i]);
        std::fputs("]", stdout);
    }

    void answer(const Work &work) const
    {
        std::size_t state;
        std::cin >> state;
        const char *before = "{";
        for (const auto &[name, values] : work.answer(state))
        {
            std::printf("%s\"%s\": ", before, name.c_str());
            numbers(values);
            before = ", ";
        }
        std::puts("}");
    }

    template <class Call> static double nanoseconds(const Call &call)
    {
        const auto start = std::chrono::steady_clock::now();
        call();
        return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
    }

    void time(const Work &work) const
    {
        std::size_t passes;
        std::cin >> passes;
        double sum = 0.0;
        for (std::size_t first = 0; first < states; first += TOGETHER)
        {
            const auto some = [&] {
                for (std::size_t s = first; s < std::min(first + TOGETHER, states); ++s) work.call(s);
            };
            some(); // warms the caches
            double least = nanoseconds(some);
            for (std::size_t i = 1; i < passes; ++i) least = std::min(least, nanoseconds(some));
            sum += least;
        }
        std::printf("%.17g\n", sum / double(states));
    }

    void cold(const Work &work)
    {
        std::vector<double> times;
        for (std::size_t s = 0; s < std::min(states, COLD_STATES); ++s)
        {
            // The other works' instructions, then numbers.
            for (const auto &other : works)
                if (other.name != work.name) other.call(s);
            for (std::size_t i = 0; i < walked.size(); i += 8) walked[i] += 1.0;
            times.push_back(nanoseconds([&] { work.call(s); }));
        }
        numbers(times);
        std::puts("");
    }
};

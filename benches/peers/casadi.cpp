// C that CasADi generated:  casadi_times CONTESTANT STATES   with the states of the tree; list.h names the functions

#include <fstream>
#include <memory>

#include "list.h"
#include "serve.hpp"
#include "works.h"

struct Function
{
    casadi_int (*count)();
    const char *(*name)(casadi_int);
    const casadi_int *(*sparsity)(casadi_int);
    int (*call)(const casadi_real **, casadi_real **, casadi_int *, casadi_real *, int);
};

// Outputs of a function, dense.
struct Answer
{
    Function function;
    std::vector<std::vector<double>> outputs;

    explicit Answer(Function function) : function(function)
    {
        for (casadi_int k = 0; k < function.count(); ++k)
        {
            const casadi_int *size = function.sparsity(k);
            outputs.emplace_back(std::size_t(size[0]) * std::size_t(size[1]));
        }
    }

    void call(const double *state)
    {
        const double *inputs[] = {state, state + JOINTS, state + 2 * JOINTS + 6};
        double *results[8];
        for (std::size_t k = 0; k < outputs.size(); ++k) results[k] = outputs[k].data();
        function.call(inputs, results, nullptr, nullptr, 0);
    }

    Parts parts() const
    {
        Parts found;
        for (std::size_t k = 0; k < outputs.size(); ++k) found.emplace_back(function.name(static_cast<casadi_int>(k)), outputs[k]);
        return found;
    }
};

int main(int count, char **arguments)
{
    if (count != 3) fail("expected CONTESTANT STATES");
    std::ifstream in(arguments[2]);
    if (!in) fail(std::string("cannot open ") + arguments[2]);

    // A line holds Q(n) QD(n) V(6) F(6+n); the functions read q, [V, q̇], F.
    std::vector<std::vector<double>> states;
    for (double number; in >> number;)
    {
        std::vector<double> line{number};
        while (line.size() < 3 * JOINTS + 12 && in >> number) line.push_back(number);
        const std::vector<double> rates(line.begin() + JOINTS, line.begin() + 2 * JOINTS);
        for (std::size_t k = 0; k < 6; ++k) line[JOINTS + k] = line[2 * JOINTS + k];
        for (std::size_t k = 0; k < JOINTS; ++k) line[JOINTS + 6 + k] = rates[k];
        states.push_back(line);
    }

    std::vector<Work> works;
    const auto add = [&](const char *name, Function function) {
        const auto answer = std::make_shared<Answer>(function);
        const auto call = [answer, &states](std::size_t s) { answer->call(states[s].data()); };
        works.push_back({name, call, [call, answer](std::size_t s) { return call(s), answer->parts(); }});
    };
#define W(name) add(#name, {name##_n_out, name##_name_out, name##_sparsity_out, name});
    WORKS
    Server(arguments[1], states.size(), works).serve();
}

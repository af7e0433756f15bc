// MuJoCo on a robot that mujoco_model.py wrote:  mujoco_times CONTESTANT MODEL.mjb STATES

#include <fstream>

#include <mujoco/mujoco.h>

#include "serve.hpp"

struct State
{
    std::vector<double> qpos, qvel, force;
};

int main(int count, char **arguments)
{
    if (count != 4) fail("expected CONTESTANT MODEL.mjb STATES");
    mjModel *model = mj_loadModel(arguments[2], nullptr);
    if (!model) fail(std::string("cannot load ") + arguments[2]);
    mjData *data = mj_makeData(model);
    const auto nv = std::size_t(model->nv);

    std::ifstream in(arguments[3]);
    if (!in) fail(std::string("cannot open ") + arguments[3]);
    const auto vector = [&](int size) {
        std::vector<double> numbers(static_cast<std::size_t>(size));
        for (auto &number : numbers) in >> number;
        return numbers;
    };
    std::vector<State> states;
    while (in >> std::ws && !in.eof())
    {
        auto qpos = vector(model->nq), qvel = vector(model->nv), force = vector(model->nv);
        states.push_back({std::move(qpos), std::move(qvel), std::move(force)});
    }

    std::vector<double> mass(nv * nv);
    const auto inertia = [&](std::size_t s) {
        mju_copy(data->qpos, states[s].qpos.data(), model->nq);
        mj_kinematics(model, data);
        mj_comPos(model, data);
        mj_makeM(model, data);
        mj_fullM(model, data, mass.data());
    };
    const auto forward = [&](std::size_t s) {
        mju_copy(data->qpos, states[s].qpos.data(), model->nq);
        mju_copy(data->qvel, states[s].qvel.data(), model->nv);
        mju_copy(data->qfrc_applied, states[s].force.data(), model->nv);
        mj_forward(model, data);
    };
    const auto acceleration = [&] { return Parts{{"classical_acceleration", {data->qacc, data->qacc + nv}}}; };
    const std::vector<Work> works = {
        {"mass", inertia, [&](std::size_t s) { return inertia(s), Parts{{"mass", mass}}; }},
        {"forward", forward, [&](std::size_t s) { return forward(s), acceleration(); }},
    };
    Server(arguments[1], states.size(), works).serve();
    mj_deleteData(data);
    mj_deleteModel(model);
}

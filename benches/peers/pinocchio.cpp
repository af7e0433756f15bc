// Times Pinocchio's algorithms on the robots that describe.py wrote:  pinocchio_times DESCRIPTION... --samples N
//
// Prints one JSON line a robot and work: {"robot", "n", "work", "ns": [N samples]}; a sample is the mean time of a call
// over all states of the file. Before timing, the results of the first state are compared with those of the wheel.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <pinocchio/multibody.hpp>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#ifdef PINOCCHIO_ENABLE_TEMPLATE_INSTANTIATION
#error "the algorithms would be the wheel's, not compiled here for this processor"
#endif

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Base = Eigen::Matrix<double, 6, Eigen::Dynamic>;
using Square6 = Eigen::Matrix<double, 6, 6>;

[[noreturn]] static void fail(const std::string &message)
{
    std::fprintf(stderr, "pinocchio_times: %s\n", message.c_str());
    std::exit(2);
}

static pinocchio::JointModel joint(const std::string &kind, const Vector3d &axis)
{
    using namespace pinocchio;
    static const std::map<std::string, std::function<JointModel(const Vector3d &)>> kinds = {
        {"JointModelFreeFlyer", [](const Vector3d &) { return JointModelFreeFlyer(); }},
        {"JointModelRX", [](const Vector3d &) { return JointModelRX(); }},
        {"JointModelRY", [](const Vector3d &) { return JointModelRY(); }},
        {"JointModelRZ", [](const Vector3d &) { return JointModelRZ(); }},
        {"JointModelRUBX", [](const Vector3d &) { return JointModelRUBX(); }},
        {"JointModelRUBY", [](const Vector3d &) { return JointModelRUBY(); }},
        {"JointModelRUBZ", [](const Vector3d &) { return JointModelRUBZ(); }},
        {"JointModelPX", [](const Vector3d &) { return JointModelPX(); }},
        {"JointModelPY", [](const Vector3d &) { return JointModelPY(); }},
        {"JointModelPZ", [](const Vector3d &) { return JointModelPZ(); }},
        {"JointModelRevoluteUnaligned", [](const Vector3d &a) { return JointModelRevoluteUnaligned(a); }},
        {"JointModelRevoluteUnboundedUnaligned",
         [](const Vector3d &a) { return JointModelRevoluteUnboundedUnaligned(a); }},
        {"JointModelPrismaticUnaligned", [](const Vector3d &a) { return JointModelPrismaticUnaligned(a); }},
    };
    const auto found = kinds.find(kind);
    if (found == kinds.end()) fail("joint kind " + kind + " is not in the table of pinocchio.cpp");
    return found->second(axis);
}

struct Robot
{
    std::string name;
    pinocchio::Model model;
    std::vector<VectorXd> q, v, tau;
    VectorXd bias, acceleration; // of the first state, computed by the wheel
};

static Robot read(const char *path)
{
    std::ifstream in(path);
    if (!in) fail(std::string("cannot open ") + path);
    const auto expect = [&](const std::string &word) {
        std::string found;
        if (!(in >> found) || found != word) fail(std::string(path) + ": found '" + found + "', expected '" + word + "'");
    };
    const auto vector = [&](Eigen::Index size) {
        VectorXd out(size);
        for (auto &x : out)
            if (!(in >> x)) fail(std::string(path) + ": ends early, or has a word where a number should be");
        return out;
    };
    const auto matrix3 = [&] {
        const VectorXd rows = vector(9);
        return Eigen::Matrix3d(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows.data()));
    };

    Robot robot;
    Eigen::Index nq, nv;
    std::size_t joints, states;
    expect("robot");
    in >> robot.name >> nq >> nv >> joints;
    for (std::size_t j = 0; j < joints; ++j)
    {
        std::string kind;
        std::size_t parent;
        in >> kind >> parent;
        const Vector3d axis = vector(3);
        const Eigen::Matrix3d rotation = matrix3();
        const Vector3d translation = vector(3);
        const double mass = vector(1)[0];
        const Vector3d centre = vector(3);
        const auto id = robot.model.addJoint(
            parent, joint(kind, axis), pinocchio::SE3(rotation, translation), "joint_" + std::to_string(j));
        robot.model.inertias[id] = pinocchio::Inertia(mass, centre, matrix3());
    }
    if (robot.model.nq != nq || robot.model.nv != nv) fail(std::string(path) + ": joints do not add up to nq and nv");
    robot.model.gravity.setZero();
    expect("states");
    in >> states;
    for (std::size_t s = 0; s < states; ++s)
    {
        robot.q.push_back(vector(nq));
        robot.v.push_back(vector(nv));
        robot.tau.push_back(vector(nv));
    }
    expect("expected");
    robot.bias = vector(nv);
    robot.acceleration = vector(nv);
    return robot;
}

// Λ_b, A_l, Λ_q from the mass matrix, and C in the velocities (μ, q̇): what a user of the reduced equations adds.
// V = T ξ with T = [1, −A; 0, 1], so C_ξ = Tᵀ(C T + M Ṫ), where Λ_b Ȧ = dM_bq/dt − dΛ_b/dt A and dM/dt = C + Cᵀ.
struct Split
{
    Base connection, connection_rate, gathered;
    MatrixXd shape, coriolis;

    void inertia(const pinocchio::Data &data)
    {
        const auto n = data.M.cols() - 6;
        const Square6 locked = data.M.topLeftCorner<6, 6>().selfadjointView<Eigen::Upper>();
        factor.compute(locked);
        connection = factor.solve(data.M.topRightCorner(6, n));
        shape = data.M.bottomRightCorner(n, n);
        shape.noalias() -= data.M.topRightCorner(6, n).transpose() * connection;
    }

    void velocity(const pinocchio::Data &data)
    {
        const auto n = data.M.cols() - 6;
        const auto &C = data.C;
        const Square6 locked_rate = C.topLeftCorner<6, 6>() + C.topLeftCorner<6, 6>().transpose();
        gathered = C.topRightCorner(6, n) + C.bottomLeftCorner(n, 6).transpose();
        gathered.noalias() -= locked_rate * connection;
        connection_rate = factor.solve(gathered);

        coriolis = C;
        coriolis.rightCols(n).noalias() -= C.leftCols<6>() * connection;
        coriolis.topRightCorner(6, n) -= gathered;
        coriolis.bottomRightCorner(n, n).noalias() -= data.M.topRightCorner(6, n).transpose() * connection_rate;
        coriolis.bottomRows(n).noalias() -= connection.transpose() * coriolis.topRows<6>();
    }

  private:
    Eigen::LLT<Square6> factor;
};

static void check(const Robot &robot, pinocchio::Data &data)
{
    const auto near = [&](const char *what, const VectorXd &ours, const VectorXd &wheel) {
        const double error = (ours - wheel).cwiseAbs().maxCoeff() / wheel.cwiseAbs().maxCoeff();
        if (!(error <= 1e-9)) fail(robot.name + ": " + what + " differs from the wheel's by " + std::to_string(error));
    };
    const auto &q = robot.q[0], &v = robot.v[0], &tau = robot.tau[0];
    near("C(q, v) v", pinocchio::computeCoriolisMatrix(robot.model, data, q, v) * v, robot.bias);
    near("rnea", pinocchio::rnea(robot.model, data, q, v, robot.acceleration), tau);
    for (const auto convention : {pinocchio::Convention::LOCAL, pinocchio::Convention::WORLD})
    {
        pinocchio::crba(robot.model, data, q, convention);
        near("M a", data.M.selfadjointView<Eigen::Upper>() * robot.acceleration, tau - robot.bias);
        near("aba", pinocchio::aba(robot.model, data, q, v, tau, convention), robot.acceleration);
    }

    // The split velocities: their bias must be the one of (V₁, q̇), its lower rows less A_lᵀ times the upper ones.
    Split split;
    pinocchio::crba(robot.model, data, q, pinocchio::Convention::WORLD);
    split.inertia(data);
    pinocchio::computeCoriolisMatrix(robot.model, data, q, v);
    split.velocity(data);
    VectorXd xi = v, bias = robot.bias;
    xi.head<6>() += split.connection * v.tail(v.size() - 6);
    bias.tail(v.size() - 6) -= split.connection.transpose() * bias.head<6>();
    // C_ξ ξ also carries M Ṫ ξ, whose upper rows are −Λ_b Ȧ_l q̇ and whose lower rows the split cancels.
    bias.head<6>() -= split.gathered * v.tail(v.size() - 6);
    near("C in (μ, q̇)", split.coriolis * xi, bias);
}

int main(int count, char **arguments)
{
    using namespace pinocchio;
    int samples = 5;
    std::vector<const char *> paths;
    for (int i = 1; i < count; ++i)
    {
        if (std::string(arguments[i]) != "--samples") paths.push_back(arguments[i]);
        else if (++i == count || (samples = std::atoi(arguments[i])) < 1) fail("--samples takes a positive number");
    }
    if (paths.empty()) fail("name at least one description (describe.py writes them)");

    for (const char *path : paths)
    {
        const Robot robot = read(path);
        const auto &model = robot.model;
        Data data(model);
        Split split;
        const std::vector<VectorXd> &q = robot.q, &v = robot.v, &tau = robot.tau;
        check(robot, data);

        // Small robots are faster in joint frames, large ones in the world's: measure both, the report takes the better.
        using Work = std::pair<std::string, std::function<void(std::size_t)>>;
        std::vector<Work> works = {
            {"kinematics", [&](auto s) { computeJointJacobians(model, data, q[s]); }},
            {"coriolis", [&](auto s) { computeCoriolisMatrix(model, data, q[s], v[s]); }},
            {"rnea", [&](auto s) { rnea(model, data, q[s], v[s], tau[s]); }},
        };
        for (const auto convention : {Convention::LOCAL, Convention::WORLD})
        {
            const std::string suffix = convention == Convention::WORLD ? "_world" : "_local";
            const std::vector<Work> both = {
                {"aba", [&, convention](auto s) { aba(model, data, q[s], v[s], tau[s], convention); }},
                {"crba", [&, convention](auto s) { crba(model, data, q[s], convention); }},
                {"crba_split",
                 [&, convention](auto s) {
                     crba(model, data, q[s], convention);
                     split.inertia(data);
                 }},
                {"crba_coriolis",
                 [&, convention](auto s) {
                     crba(model, data, q[s], convention);
                     computeCoriolisMatrix(model, data, q[s], v[s]);
                 }},
                {"crba_coriolis_split",
                 [&, convention](auto s) {
                     crba(model, data, q[s], convention);
                     split.inertia(data);
                     computeCoriolisMatrix(model, data, q[s], v[s]);
                     split.velocity(data);
                 }},
            };
            for (const auto &[work, call] : both) works.emplace_back(work + suffix, call);
        }
        for (const auto &[work, call] : works)
        {
            std::printf("{\"robot\":\"%s\",\"n\":%d,\"work\":\"%s\",\"ns\":[", robot.name.c_str(), model.nv - 6, work.c_str());
            for (int sample = -1; sample < samples; ++sample) // the first warms the caches
            {
                const auto start = std::chrono::steady_clock::now();
                for (std::size_t s = 0; s < q.size(); ++s) call(s);
                const std::chrono::duration<double, std::nano> spent = std::chrono::steady_clock::now() - start;
                if (sample >= 0) std::printf("%s%.1f", sample ? "," : "", spent.count() / double(q.size()));
            }
            std::printf("]}\n");
        }
    }
}

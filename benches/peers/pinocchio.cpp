// Pinocchio's algorithms on a robot that describe.py wrote:  pinocchio_times CONTESTANT DESCRIPTION   (serve.hpp says what it is asked)

#include <array>
#include <fstream>
#include <map>

#include <pinocchio/multibody.hpp>

#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include "serve.hpp"

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Base = Eigen::Matrix<double, 6, Eigen::Dynamic>;
using Square6 = Eigen::Matrix<double, 6, 6>;

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

    // The velocity whose momentum is one about an axis of the base. Linear first, as all of Pinocchio.
    Eigen::Matrix<double, 6, 1> velocity_of(Eigen::Index axis) const
    {
        return factor.solve(Eigen::Matrix<double, 6, 1>::Unit(3 + axis));
    }

  private:
    Eigen::LLT<Square6> factor;
};

// The motion of all as one body with a momentum of one about an axis: its C holds that row of the curvature.
static VectorXd turning(const Split &split, Eigen::Index axis, Eigen::Index nv)
{
    VectorXd v = VectorXd::Zero(nv);
    v.head<6>() = split.velocity_of(axis);
    return v;
}

static std::vector<double> flat(const MatrixXd &matrix)
{
    return {matrix.data(), matrix.data() + matrix.size()};
}

int main(int count, char **arguments)
{
    using namespace pinocchio;
    if (count != 3) fail("expected CONTESTANT DESCRIPTION");
    const Robot robot = read(arguments[2]);
    const auto &model = robot.model;
    const auto nv = model.nv;
    const auto &q = robot.q, &v = robot.v, &tau = robot.tau;
    Data data(model);
    Split split;
    std::array<MatrixXd, 3> curvature;

    const auto mass = [&](auto) { return Parts{{"mass", flat(MatrixXd(data.M.selfadjointView<Eigen::Upper>()))}}; };
    const auto inertia = [&](auto) {
        // Of symmetric matrices Pinocchio computes the upper halves.
        const Square6 locked = data.M.topLeftCorner<6, 6>().selfadjointView<Eigen::Upper>();
        const MatrixXd shape = split.shape.selfadjointView<Eigen::Upper>();
        return Parts{{"locked_inertia", flat(locked)}, {"connection", flat(split.connection)}, {"shape_inertia", flat(shape)}};
    };
    const auto matrices = [&](auto s) {
        auto parts = inertia(s);
        parts.emplace_back("coriolis", flat(split.coriolis));
        return parts;
    };
    const auto acceleration = [&](auto) { return Parts{{"acceleration", flat(data.ddq)}}; };
    const auto curved = [&](auto) {
        MatrixXd layers(nv - 6, 3 * (nv - 6));
        layers << curvature[0], curvature[1], curvature[2];
        return Parts{{"curvature", flat(layers)}};
    };

    // Small robots are faster in joint frames, large ones in the world's: both are measured, the faster one counts.
    std::vector<Work> works;
    for (const auto convention : {Convention::LOCAL, Convention::WORLD})
    {
        const std::string suffix = convention == Convention::WORLD ? "_world" : "_local";
        const auto add = [&](const char *name, auto call, auto parts) {
            works.push_back({name + suffix, call, [call, parts](std::size_t s) { return call(s), parts(s); }});
        };
        const auto crba = [&, convention](std::size_t s) { pinocchio::crba(model, data, q[s], convention); };
        add("mass", crba, mass);
        add("inertia", [&, crba](std::size_t s) { crba(s), split.inertia(data); }, inertia);
        add("mass_coriolis", [&, crba](std::size_t s) { crba(s), computeCoriolisMatrix(model, data, q[s], v[s]); }, mass);
        add("matrices",
            [&, crba](std::size_t s) {
                crba(s), split.inertia(data);
                computeCoriolisMatrix(model, data, q[s], v[s]), split.velocity(data);
            },
            matrices);
        add("forward", [&, convention](std::size_t s) { aba(model, data, q[s], v[s], tau[s], convention); }, acceleration);
        add("curvature",
            [&, crba](std::size_t s) {
                crba(s), split.inertia(data);
                for (int axis = 0; axis < 3; ++axis)
                {
                    computeCoriolisMatrix(model, data, q[s], turning(split, axis, nv)), split.velocity(data);
                    curvature[axis] = -2.0 * split.coriolis.bottomRightCorner(nv - 6, nv - 6);
                }
            },
            curved);
    }
    Server(arguments[1], q.size(), works).serve();
}

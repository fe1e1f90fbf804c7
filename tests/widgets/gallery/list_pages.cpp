#include "core/protocol/reader.h"
#include "tests/widgets/gallery/pages.h"
#include "widgets/messages/message_list.h"
#include "widgets/messages/notification_center.h"
#include "widgets/messages/toast_stack.h"
#include "widgets/panels/robot_list.h"

namespace usar::gallery {

using namespace usar::widgets;

std::unique_ptr<QWidget> robotsPage() {
    auto list = std::make_unique<RobotList>();
    list->resize(260, 300);
    const RobotRow rows[] = {
        {{1}, 1, QStringLiteral("R1"), QStringLiteral("AirRobot"), QStringLiteral("scanning lane 4 of 9"), 71.0, false},
        {{2}, 2, QStringLiteral("R2"), QStringLiteral("P2DX"), QStringLiteral("idle"), 22.0, false},
        {{3},
         3,
         QStringLiteral("Hilltop-watcher"),
         QStringLiteral("AirRobot"),
         QStringLiteral("returning to recharge, 120 m to go over the wood"),
         9.0,
         false},
        {{4}, 4, QStringLiteral("R4"), QStringLiteral("AirRobot"), QStringLiteral("scanning lane 2 of 3"), 55.0, true},
        {{5}, 5, QStringLiteral("R5"), QStringLiteral("Submarine"), QStringLiteral("spawning"), std::nullopt, false},
    };
    for (const RobotRow& row : rows)
        list->updateRobot(row);
    list->selectRobot({1});
    return list;
}

std::unique_ptr<QWidget> emptyRobotsPage() {
    auto list = std::make_unique<RobotList>();
    list->resize(260, 220);
    return list;
}

namespace {

void report(NotificationModel& model) {
    const QDateTime noon(QDate(2024, 5, 1), QTime(12, 31, 5));
    model.push(QStringLiteral("scan"), Severity::Note, QStringLiteral("The scan was saved to USAR_Scan/scan-1."), noon);
    model.push(QStringLiteral("range"), Severity::Warning,
               QStringLiteral("R2: sonar F3 has not answered for 5 s. The robot flies on without it."), noon);
    model.push(QStringLiteral("plugin"), Severity::Error,
               QStringLiteral("p2dx.so was refused: it was built for another version of the SDK. Build it again."),
               noon);
    for (int i = 0; i < 137; ++i)
        model.push(QStringLiteral("link"), Severity::Error,
                   QStringLiteral("No answer from 10.0.0.5:3000 after 5 s. Is USARSim running there? Retrying in 4 s."),
                   noon.addSecs(i));
}

} // namespace

std::unique_ptr<QWidget> notificationsPage() {
    auto center = std::make_unique<NotificationCenter>();
    center->resize(420, 260);
    report(*center->model());
    center->cured(QStringLiteral("range"));
    return center;
}

std::unique_ptr<QWidget> messagesPage() {
    auto list = std::make_unique<MessageList>();
    list->resize(820, 260);
    protocol::Reader reader;
    const auto in = [&](const char* text, double time) { list->takeLine(reader.read(text), Seconds(time)); };
    in("NFO {Gametype USARDeathmatch} {Level tall_test}", 0.0);
    for (int i = 0; i < 4; ++i) {
        const double time = 751.2 + i * 0.2;
        in("STA {Type AerialVehicle} {Time 751.20} {Battery 1134}", time);
        in("SEN {Time 751.20} {Type Sonar} {Name F1 Range 4.5210} {Name F2 Range 5.0000} {Name F3 Range 1.2000}", time);
        list->takeCommand("DRIVE {AltitudeVelocity 0} {LinearVelocity 2.5}",
                          {by::Behavior{"airrobot/cpp", "scanning lane 4"}, {12}}, Seconds(time));
    }
    in("SEN {Time 752.00} {Type INS} {Name INS {Location 1,2", 752.0);
    return list;
}

std::unique_ptr<QWidget> toastsPage() {
    auto window = std::make_unique<QWidget>();
    window->resize(640, 360);
    auto* model = new NotificationModel(window.get());
    new ToastStack(window.get(), model);
    report(*model);
    return window;
}

} // namespace usar::gallery

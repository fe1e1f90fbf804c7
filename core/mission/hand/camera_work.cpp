#include "core/mission/hand/camera_work.h"

#include <utility>

namespace usar::mission {

namespace {

constexpr int most_questions = 3;
constexpr int answer_patience_ms = 2500;
constexpr int set_patience_ms = 500;
constexpr int turn_interval_ms = 100;

} // namespace

CameraWork::CameraWork(std::function<bool()> live, Send send) : live_(std::move(live)), send_(std::move(send)) {
    for (QTimer* const timer : {&answer_timer_, &turn_timer_, &set_timer_})
        timer->setSingleShot(true);
    connect(&answer_timer_, &QTimer::timeout, this, &CameraWork::unanswered);
    connect(&turn_timer_, &QTimer::timeout, this, &CameraWork::sendTurn);
    connect(&set_timer_, &QTimer::timeout, this, &CameraWork::sendSet);
}

void CameraWork::restart() {
    questions_ = 0;
    answer_timer_.stop();
    turn_timer_.stop();
    mount_ = {};
    attached_.clear();
}

void CameraWork::take(const protocol::InfoMessage& message) {
    using News = CameraMount::News;
    const News news = mount_.take(message);
    if (news == News::Cameras)
        answer_timer_.stop();
    if (news == News::Cameras || news == News::Picture)
        emit pictureChanged();
    if (news == News::Cameras)
        emit camerasKnown();
    else if (news == News::Abilities)
        emit abilitiesChanged();
    if (mount_.takeAnswered())
        sendSet();
}

void CameraWork::ask() {
    if (mount_.answered() || answer_timer_.isActive() || questions_ >= most_questions)
        return;
    ++questions_;
    answer_timer_.start(answer_patience_ms);
    send_(protocol::GetConfiguration{"Camera"});
}

void CameraWork::attach(const QString& robot, const QString& address) {
    const auto* const shown = mount_.shown();
    if (!shown || address.isEmpty())
        return;
    const std::string& camera = shown->configuration.name;
    const QString wanted = robot + '/' + QString::fromStdString(camera) + '/' + address;
    const auto name = protocol::Token::make(robot.toStdString());
    const auto viewer = protocol::Token::make(address.toStdString());
    const auto camera_name = protocol::Name::make(camera);
    if (wanted == attached_ || !name || !viewer || !camera_name)
        return;
    attached_ = wanted;
    mount_.queue(protocol::AttachCamera{*name, *viewer, *camera_name});
    sendSetSoon();
}

void CameraWork::zoomTo(double fov_rad) {
    mount_.zoomTo(fov_rad);
    sendZoom();
}

void CameraWork::zoomBy(double factor) {
    mount_.zoomBy(factor);
    sendZoom();
}

void CameraWork::resetZoom() {
    mount_.resetZoom();
    sendZoom();
}

void CameraWork::sendZoom() {
    emit pictureChanged();
    sendSetSoon();
}

void CameraWork::sendSetSoon() {
    if (!set_timer_.isActive())
        sendSet();
}

void CameraWork::sendSet() {
    set_timer_.stop();
    if (!live_())
        return;
    if (const auto set = mount_.next()) {
        send_(*set);
        set_timer_.start(set_patience_ms);
    }
}

void CameraWork::turnSoon(bool turned) {
    if (!turned)
        return;
    mount_.setTurning(true);
    if (!turn_timer_.isActive())
        turn_timer_.start(turn_interval_ms);
}

void CameraWork::center() {
    mount_.center();
    sendTurn();
}

void CameraWork::sendTurn() {
    mount_.setTurning(false);
    if (const auto drive = mount_.drive(); drive && live_())
        send_(*drive);
}

} // namespace usar::mission

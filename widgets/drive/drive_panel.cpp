#include "widgets/drive/drive_panel.h"

#include <cmath>

#include <QScrollArea>

#include "core/base/geometry.h"
#include "widgets/drive/drive_keys.h"
#include "widgets/drive/drive_pad.h"
#include "widgets/models/figures.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"

namespace usar::widgets {

namespace {

constexpr int speed_steps = 20;

QLabel* smallLabel(const QString& text, QWidget* parent) {
    QLabel* label = mutedLabel(text, parent);
    label->setFont(themeFont(FontRole::Small));
    return label;
}

} // namespace

DrivePanel::DrivePanel(QWidget* parent)
    : QWidget(parent)
    , stop_(makeStopButton({}, tr("Stops this robot at once, whoever drives it (Space while you drive)"), this)) {
    auto* scroll = new QScrollArea(this); // It also prevents changing figures from laying out the whole window again.
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidgetResizable(true);
    scroll->setWidget(content_);
    laidOut(new QVBoxLayout(this), {gap::small, gap::small, gap::small, gap::small}, gap::small, {scroll, stop_})
        ->setStretchFactor(scroll, 1);
    auto* column = laidOut(new QVBoxLayout(content_), {}, gap::small);
    badge_->setBare(true);
    column->addWidget(badge_, 0, Qt::AlignTop); // Also visible above the empty state.
    column->addWidget(take_);
    makePads();
    makeSpeed();
    makeFigures();
    take_->setMinimumHeight(minimum_target);
    connect(take_, &QPushButton::clicked, this, [this] { emit takeRequested(!state_.taken); });
    connect(stop_, &QPushButton::clicked, this, &DrivePanel::stopRequested);
    empty_->raise();
    setState({});
    setVelocity({}, false);
    setEmpty({}, {});
}

void DrivePanel::makePads() {
    auto* grid = new QGridLayout;
    grid->setSpacing(gap::tiny);
    pad_ = new DrivePad(PadShape::Both, content_);
    side_ = new DrivePad(PadShape::Across, content_);
    lift_ = new DrivePad(PadShape::Upright, content_);
    named(
        pad_, tr("Drive and turn"),
        tr("Drag and hold: up drives forward, left turns left; let go to stop. With the focus here, the arrow keys do "
           "the same"));
    named(side_, tr("Sideways"), tr("Drag and hold: left or right without turning; let go to stop"));
    named(lift_, tr("Up and down"), tr("Drag and hold: climb or descend; let go to stop"));
    grid->addWidget(pad_, 0, 0);
    grid->addWidget(lift_, 0, 1);
    grid->addWidget(side_, 1, 0);
    static_cast<QVBoxLayout*>(content_->layout())->addLayout(grid, 1);
    for (DrivePad* const pad : {pad_, side_, lift_})
        connect(pad, &DrivePad::moved, this, [this] { emit moved(stick()); });
}

void DrivePanel::makeSpeed() {
    speed_->setRange(1, speed_steps);
    speed_->setValue(speed_steps * 2 / 5);
    speed_->setMinimumHeight(minimum_target);
    speed_->setAccessibleName(tr("Speed limit"));
    speed_text_->setAccessibleName(tr("Speed at full stick"));
    speed_text_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    speed_text_->setFixedSize(speed_text_->fontMetrics().horizontalAdvance(QStringLiteral("100 % · 00.0 m/s")),
                              minimum_target);
    auto* row = laidOut(new QHBoxLayout, gap::small, {new QLabel(tr("Speed"), content_), speed_, speed_text_});
    row->setStretchFactor(speed_, 1);
    static_cast<QVBoxLayout*>(content_->layout())->addLayout(row);
    connect(speed_, &QSlider::valueChanged, this, [this] {
        showSpeed();
        emit speedShareChanged(speedShare());
    });
}

void DrivePanel::makeFigures() {
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(gap::medium);
    grid->setVerticalSpacing(2);
    grid->setColumnStretch(0, 1);
    grid->addWidget(smallLabel(tr("stick"), content_), 0, 1, Qt::AlignRight);
    grid->addWidget(smallLabel(tr("measured"), content_), 0, 2, Qt::AlignRight);
    const QString names[] = {tr("Forward"), tr("Left"), tr("Up"), tr("Turn left")};
    for (std::size_t i = 0; i < figures_.size(); ++i) {
        FigureRow& row = figures_[i];
        row = {new QLabel(names[i], content_), new QLabel(content_), new QLabel(content_)};
        for (QLabel* const label : {row.sent, row.measured}) {
            const QString widest = label == row.sent ? QStringLiteral("−100 %") : QStringLiteral("−00.00 m/s");
            label->setFixedSize(label->fontMetrics().horizontalAdvance(widest), label->fontMetrics().height());
            label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        }
        const int line = static_cast<int>(i) + 1;
        grid->addWidget(row.name, line, 0);
        grid->addWidget(row.sent, line, 1, Qt::AlignRight);
        grid->addWidget(row.measured, line, 2, Qt::AlignRight);
    }
    auto* column = static_cast<QVBoxLayout*>(content_->layout());
    column->addLayout(grid);
    echo_->setFont(codeFont());
    echo_->setAccessibleName(tr("What is sent"));
    gamepad_->setProperty("role", "muted");
    gamepad_->setFont(themeFont(FontRole::Small));
    gamepad_->setAccessibleName(tr("Gamepad"));
    note_->setWordWrap(true);
    note_->setFont(themeFont(FontRole::Small));
    note_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    // There is always room for two lines, so that the rows below do not move.
    note_->setMinimumHeight(2 * QFontMetrics(themeFont(FontRole::Small)).height());
    column->addWidget(echo_);
    column->addWidget(note_);
    column->addWidget(gamepad_);
    setEcho({});
}

void DrivePanel::setState(const DriveState& state) {
    state_ = state;
    badge_->setWords(state.control);
    const bool behavior = state.control.driver == Driver::Behavior;
    take_->setText(state.taken ? tr("Give control back") : behavior ? tr("Take control") : tr("Drive by hand"));
    take_->setToolTip(state.taken ? tr("Gives up control; a paused behavior waits to be resumed (G)")
                      : behavior  ? tr("Pauses the behavior; you drive from then on (G)")
                                  : tr("Keys, pad and gamepad drive while they are held (G)"));
    take_->setEnabled(state.can_take);
    setRole(take_, state.taken ? "" : "primary");
    stop_->setText(state.robot.isEmpty() ? tr("STOP") : tr("STOP %1").arg(state.robot));
    stop_->setEnabled(!state.robot.isEmpty());
    note_->setText(state.note);
    setRole(note_, state.note_is_trouble ? "caution" : "muted");
    showAxes();
    pad_->setShown({-state.asked.turn, state.asked.forward}, {-state.sent.turn, state.sent.forward});
    side_->setShown({-state.asked.left, 0.0}, {-state.sent.left, 0.0});
    lift_->setShown({0.0, state.asked.up}, {0.0, state.sent.up});
    showFigures();
    showSpeed();
}

void DrivePanel::showAxes() {
    const StickAxes& axes = state_.axes;
    side_->setVisible(axes.left && empty_title_.isEmpty());
    lift_->setVisible(axes.up && empty_title_.isEmpty());
    pad_->setKeys(state_.taken ? DriveKeys::turnKeys(axes) : QStringList());
    side_->setKeys(state_.taken ? DriveKeys::sideKeys() : QStringList());
    lift_->setKeys(state_.taken ? DriveKeys::liftKeys() : QStringList());
    for (DrivePad* const pad : {pad_, side_, lift_})
        pad->setEnabled(state_.taken && axes.any());
    const bool shown[] = {axes.forward, axes.left, axes.up, axes.turn};
    for (std::size_t i = 0; i < figures_.size(); ++i)
        for (QLabel* const label : {figures_[i].name, figures_[i].sent, figures_[i].measured})
            label->setVisible(shown[i] && empty_title_.isEmpty());
}

void DrivePanel::showFigures() {
    const Stick& sent = state_.sent;
    const double shares[] = {sent.forward, sent.left, sent.up, sent.turn};
    const std::optional<double> measured[] = {velocity_.forward_m_s, velocity_.left_m_s, velocity_.up_m_s,
                                              velocity_.turn_rad_s};
    for (std::size_t i = 0; i < figures_.size(); ++i) {
        figures_[i].sent->setText(figure(100.0 * shares[i], 0) + QStringLiteral(" %"));
        const bool turns = i == 3;
        const QString unit = turns ? QStringLiteral(" °/s") : QStringLiteral(" m/s");
        figures_[i].measured->setText(
            measured[i] ? figure(turns ? degrees(*measured[i]) : *measured[i], turns ? 0 : 2) + unit : tr("–"));
        setRole(figures_[i].measured, velocity_stale_ ? "muted" : "");
    }
}

void DrivePanel::showSpeed() {
    QString text = figure(100.0 * speedShare(), 0) + QStringLiteral(" %");
    if (state_.top_speed_m_s)
        text += tr(" · %1 m/s").arg(figure(*state_.top_speed_m_s * speedShare(), 1));
    speed_text_->setText(text);
    const auto share = [this](double part) {
        return figure(100.0 * part, 0) + QStringLiteral(" %") +
               (state_.top_speed_m_s ? tr(" (%1 m/s)").arg(figure(*state_.top_speed_m_s * part, 2)) : QString());
    };
    tellRange(speed_, tr("Speed at full stick, as a share of the robot's top speed"), share(1.0 / speed_steps),
              share(1.0));
}

void DrivePanel::setEmpty(const QString& title, const QString& hint) {
    if (empty_title_ == title && empty_->accessibleDescription() == hint)
        return;
    empty_title_ = title;
    empty_->setVisible(!title.isEmpty());
    for (QWidget* const child : content_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (child != empty_ && child != badge_)
            child->setVisible(title.isEmpty());
    empty_->setText(title, hint);
    if (title.isEmpty())
        showAxes();
}

void DrivePanel::setVelocity(const BodyVelocity& velocity, bool stale) {
    if (velocity == velocity_ && stale == velocity_stale_)
        return;
    velocity_ = velocity;
    velocity_stale_ = stale;
    showFigures();
}

void DrivePanel::setEcho(const QString& line) {
    const QString text = line.isEmpty() ? tr("nothing sent yet") : line;
    if (text == echo_->text())
        return;
    echo_->setText(text);
    echo_->setToolTip(tr("What is sent: %1").arg(text));
}

void DrivePanel::setGamepad(const QString& text) {
    gamepad_->setText(text);
    gamepad_->setToolTip(text);
}

Stick DrivePanel::stick() const {
    return {pad_->value().y(), -side_->value().x(), -pad_->value().x(), lift_->value().y()};
}

double DrivePanel::speedShare() const {
    return static_cast<double>(speed_->value()) / speed_steps;
}

void DrivePanel::setSpeedShare(double share) {
    speed_->setValue(static_cast<int>(std::lround(share * speed_steps)));
}

void DrivePanel::letGo() {
    for (DrivePad* const pad : {pad_, side_, lift_})
        pad->letGo();
}

} // namespace usar::widgets

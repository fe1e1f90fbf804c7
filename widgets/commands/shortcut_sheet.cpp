#include "widgets/commands/shortcut_sheet.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QObject>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollBar>

#include "widgets/commands/key_map.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"
#include "widgets/style/tool_button.h"

namespace usar::widgets {
namespace {

/// A heading, and below it pairs of keys or a gesture and their effect.
struct Group {
    QString name;
    QList<std::pair<QString, QString>> lines;
};

/// The text without the number at its end: "Select robot " of "Select robot 1".
QString stemOf(const QString& text) {
    static const QRegularExpression number("\\d+$");
    return text.left(text.size() - number.match(text).capturedLength());
}

/// Adds a line; one that differs from the last line by the number of key and effect only widens that line: "1 – 9".
void append(Group& group, const QString& keys, const QString& effect) {
    if (!group.lines.isEmpty()) {
        auto& [last_keys, last_effect] = group.lines.back();
        const QString stem = stemOf(effect);
        const QString first = last_effect.mid(stem.size()).section(u' ', 0, 0);
        if (stem != effect && last_effect.startsWith(stem) && stemOf(keys) != keys) {
            last_effect = stem + first + QStringLiteral(" – ") + effect.mid(stem.size());
            last_keys = last_keys.section(u' ', 0, 0) + QStringLiteral(" – ") + keys;
            return;
        }
    }
    group.lines.emplaceBack(keys, effect);
}

/// "F  Home  Esc Esc"; empty without a key.
QString keysOf(const CommandSpec& spec) {
    QStringList keys;
    for (const QKeySequence& sequence : spec.shortcuts)
        keys << sequence.toString(QKeySequence::NativeText);
    if (const QString key = spec.twice.toString(QKeySequence::NativeText); !key.isEmpty())
        keys << QStringLiteral("%1 %1").arg(key);
    return keys.join(QStringLiteral("  "));
}

QList<Group> groupsOf(const CommandRegistry& registry) {
    QList<Group> groups;
    for (const auto& command : registry.commands()) {
        if (command->spec.shortcuts.isEmpty())
            continue;
        auto group = std::ranges::find(groups, command->spec.group, &Group::name);
        if (group == groups.end())
            group = groups.insert(groups.end(), Group{command->spec.group, {}});
        append(*group, keysOf(command->spec), command->spec.text);
    }
    return groups;
}

/// A box with a heading and a grid for lines below it.
QWidget* groupBox(const QString& name) {
    auto* box = new QWidget;
    auto* grid = gridOf(box, {0, 0, gap::large, gap::small}, gap::medium, 0);
    auto* title = new QLabel(name);
    title->setProperty("role", "title");
    grid->addWidget(title, 0, 0, 1, 2);
    grid->setColumnMinimumWidth(0, 90);
    grid->setColumnStretch(1, 1);
    return box;
}

QWidget* groupWidget(const Group& group) {
    QWidget* const box = groupBox(group.name);
    auto* const grid = static_cast<QGridLayout*>(box->layout());
    int row = 1;
    for (const auto& [keys, effect] : group.lines) {
        grid->addWidget(mutedLabel(keys), row, 0);
        grid->addWidget(new QLabel(effect), row, 1);
        ++row;
    }
    grid->setRowStretch(row, 1);
    return box;
}

QList<std::pair<QString, QString>> gestures() {
    return {{QObject::tr("Double-click a start pose"), QObject::tr("Spawn a robot there")},
            {QObject::tr("Click a start pose"), QObject::tr("Choose class, name, behavior")},
            {QObject::tr("N  Shift+N"), QObject::tr("Next, previous start pose")},
            {QObject::tr("Drag with the area tool"), QObject::tr("Draw the mission area")},
            {QObject::tr("Wheel"), QObject::tr("Zoom at the cursor")},
            {QObject::tr("Arrow keys, drag"), QObject::tr("Pan the map")},
            {QObject::tr("W S  A D, driving"), QObject::tr("Forward and back, turn")},
            {QObject::tr("Q E  R F, driving"), QObject::tr("Sideways, up and down")},
            {QObject::tr("Shift  Space, driving"), QObject::tr("Slower, stop")},
            {QObject::tr("Drag, wheel on the camera"), QObject::tr("Turn it, zoom it")},
            {QObject::tr("Double-click a sensor value"), QObject::tr("Plot it")},
            {QObject::tr("Click an object, then the map"), QObject::tr("Put it into the world")},
            {QObject::tr("Drag an object"), QObject::tr("Move it")}};
}

/// Fills columns from top to bottom, each up to its share of the whole height, so that they are about equally high.
QWidget* inColumns(const QList<QWidget*>& boxes, int columns) {
    auto* const sheet = new QWidget;
    auto* const row = new QHBoxLayout(sheet);
    row->setContentsMargins(gap::large, gap::large, gap::large, gap::large);
    row->setSpacing(0);
    const int whole_px = std::accumulate(boxes.begin(), boxes.end(), 0, [](int sum_px, const QWidget* box) {
        return sum_px + box->sizeHint().height();
    });
    int used_px = 0;
    int filled = 0;
    auto* column = new QVBoxLayout;
    row->addLayout(column);
    for (QWidget* const box : boxes) {
        const int half_px = box->sizeHint().height() / 2;
        if (filled + 1 < columns && (used_px + half_px) * columns > whole_px * (filled + 1)) {
            column->addStretch(1);
            row->addLayout(column = new QVBoxLayout);
            ++filled;
        }
        column->addWidget(box);
        used_px += 2 * half_px;
    }
    column->addStretch(1);
    return sheet;
}

/// As many columns as the screen of this window has room for.
QWidget* sheetOf(const QList<QWidget*>& boxes, const QWidget& window) {
    int widest_px = 1;
    for (const QWidget* const box : boxes)
        widest_px = std::max(widest_px, box->sizeHint().width());
    constexpr int scroll_bar_px = 24;
    const int room_px = window.screen()->availableSize().width() - 2 * gap::large - scroll_bar_px;
    return inColumns(boxes, std::clamp(room_px / widest_px, 1, 4));
}

} // namespace

KeyButton::KeyButton(const CommandRegistry::Command& command, QWidget* parent)
    : QPushButton(parent)
    , id_(command.spec.id)
    , keys_(keysOf(command.spec)) {
    setAutoDefault(false);
    setCheckable(true);
    setMinimumHeight(minimum_target);
    setAccessibleName(tr("Key of %1").arg(command.spec.text));
    setToolTip(tr("Click, then press the new key; Delete leaves the command without one"));
    connect(this, &QPushButton::clicked, this, [this] { setWaiting(!waits_); });
    setWaiting(false);
}

void KeyButton::setWaiting(bool waits) {
    const bool changed = std::exchange(waits_, waits) != waits;
    setChecked(waits);
    setText(waits ? tr("Press a key…") : keys_.isEmpty() ? QStringLiteral("–") : keys_);
    if (waits)
        setFocus();
    if (changed)
        emit waitingChanged(waits);
}

bool KeyButton::event(QEvent* event) {
    if (!waits_ || (event->type() != QEvent::ShortcutOverride && event->type() != QEvent::KeyPress))
        return QPushButton::event(event);
    event->accept(); // Otherwise the key would run its command, or move the focus.
    if (event->type() == QEvent::ShortcutOverride)
        return true;
    const auto& press = static_cast<const QKeyEvent&>(*event);
    static const QList<int> held{Qt::Key_Shift, Qt::Key_Control, Qt::Key_Alt, Qt::Key_Meta, Qt::Key_AltGr};
    if (held.contains(press.key()) || press.isAutoRepeat())
        return true;
    if (press.key() == Qt::Key_Escape)
        setWaiting(false);
    else if (press.key() == Qt::Key_Delete && press.modifiers() == Qt::NoModifier)
        emit keyPressed({});
    else
        emit keyPressed(QKeySequence(QKeyCombination(press.modifiers() & ~Qt::KeypadModifier, Qt::Key(press.key()))));
    return true;
}

void KeyButton::focusOutEvent(QFocusEvent* event) {
    setWaiting(false);
    QPushButton::focusOutEvent(event);
}

ShortcutSheet::ShortcutSheet(CommandRegistry& registry, QWidget* window) : QDialog(window), registry_(registry) {
    setWindowTitle(tr("Keys and gestures"));
    setAccessibleName(windowTitle());
    scroll_->setWidgetResizable(true);
    scroll_->setFrameShape(QFrame::NoFrame);
    message_->setWordWrap(true);
    change_->setCheckable(true);
    change_->setToolTip(tr("Lists all commands; a click on a key waits for another one"));
    reset_->setToolTip(tr("Gives all commands their usual keys again"));
    for (QPushButton* const button : {change_, reset_}) {
        button->setAutoDefault(false);
        button->setMinimumHeight(minimum_target);
    }
    auto* const foot = laidOut(new QHBoxLayout, gap::small, {change_, message_, reset_});
    foot->setContentsMargins(gap::large, gap::small, gap::large, gap::small);
    foot->setStretchFactor(message_, 1);
    auto* const column = laidOut(new QVBoxLayout(this), {}, 0, {scroll_});
    column->addLayout(foot);
    connect(change_, &QPushButton::toggled, this, &ShortcutSheet::setEditing);
    connect(reset_, &QPushButton::clicked, this, [this] {
        registry_.takeKeys({});
        say(tr("All keys are the usual ones again."));
    });
    // Not at once: a button that was pressed is replaced.
    connect(&registry_, &CommandRegistry::keysChanged, this, &ShortcutSheet::rebuild, Qt::QueuedConnection);
    rebuild();
    const QSize room = window->screen()->availableSize() - QSize(2 * gap::large, 3 * gap::large);
    constexpr int scroll_bar_px = 24;
    // Wide enough to never need horizontal scrolling.
    resize(scroll_->widget()->sizeHint().width() + scroll_bar_px,
           std::min(scroll_->widget()->sizeHint().height() + foot->sizeHint().height(), room.height()));
}

void ShortcutSheet::setEditing(bool editing) {
    editing_ = editing;
    change_->setChecked(editing);
    say({});
    rebuild();
}

void ShortcutSheet::rebuild() {
    const int at_px = scroll_->verticalScrollBar()->value();
    scroll_->setWidget(editing_ ? editor() : overview());
    scroll_->verticalScrollBar()->setValue(at_px);
    reset_->setVisible(!registry_.changedKeys().empty());
}

QWidget* ShortcutSheet::overview() {
    QList<Group> groups = groupsOf(registry_);
    groups.append({QObject::tr("Mouse and held keys"), gestures()});
    QList<QWidget*> boxes;
    for (const Group& group : groups)
        boxes << groupWidget(group);
    return sheetOf(boxes, *this);
}

QWidget* ShortcutSheet::editor() {
    QList<QWidget*> boxes;
    std::map<QString, QGridLayout*> grids;
    for (const auto& command : registry_.commands()) {
        QGridLayout*& grid = grids[command->spec.group];
        if (!grid) {
            boxes << groupBox(command->spec.group);
            grid = static_cast<QGridLayout*>(boxes.back()->layout());
        }
        const int row = grid->rowCount();
        auto* const button = new KeyButton(*command);
        connectButton(button);
        grid->addWidget(button, row, 0);
        auto* const text = new QLabel(command->spec.text);
        grid->addWidget(text, row, 1);
        if (command->spec.shortcuts == command->first_keys)
            continue;
        text->setFont(themeFont(FontRole::Body, QFont::DemiBold));
        auto* const reset = makeToolButton(tr("Reset the key of %1").arg(command->spec.text), nullptr, "reset");
        connect(reset, &QToolButton::clicked, this, [this, id = command->spec.id] {
            KeyChoices others = registry_.changedKeys();
            others.erase(id);
            registry_.takeKeys(others);
        });
        grid->addWidget(reset, row, 2);
    }
    return sheetOf(boxes, *this);
}

void ShortcutSheet::connectButton(KeyButton* button) {
    connect(button, &KeyButton::waitingChanged, this, [this](bool waits) {
        asked_ = {};
        say(waits ? tr("Press the new key. Delete: no key. Escape: as it was.") : QString());
    });
    connect(button, &KeyButton::keyPressed, this, [this, button](const QKeySequence& key) { take(button, key); });
}

void ShortcutSheet::take(KeyButton* button, const QKeySequence& key) {
    const KeyVerdict verdict = judgeKey(registry_, button->id(), key);
    if (!verdict.possible || (!verdict.owner.isEmpty() && key != asked_)) {
        asked_ = verdict.possible ? key : QKeySequence();
        return say(verdict.words);
    }
    const QString id = button->id();
    const QString text = registry_.action(id)->text();
    button->setWaiting(false);
    giveKey(registry_, id, key);
    const QString name = key.toString(QKeySequence::NativeText);
    say(key.isEmpty() ? tr("%1 has no key now.").arg(text) : tr("%1 runs %2 now.").arg(name, text));
}

void ShortcutSheet::say(const QString& text) {
    message_->setText(text);
}

QDialog* makeShortcutSheet(CommandRegistry& registry, QWidget* window) {
    return new ShortcutSheet(registry, window);
}

} // namespace usar::widgets

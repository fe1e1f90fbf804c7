// The shortcut overview (F1): every command that has a shortcut, by group, generated from the registry, and what can be
// done with mouse and held keys. The keys can be changed there.
#pragma once

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>

#include "widgets/commands/command_registry.h"

namespace usar::widgets {

/// Waits for a key after a click, and shows the one that its command has. Delete leaves the command without a key, and
/// Escape or a click elsewhere changes nothing. GUI thread.
class KeyButton : public QPushButton {
    Q_OBJECT
public:
    KeyButton(const CommandRegistry::Command& command, QWidget* parent = nullptr);
    /// Id of the command.
    const QString& id() const { return id_; }
    /// True between the click and the key.
    bool waits() const { return waits_; }
    /// Waits, or shows the key.
    void setWaiting(bool waits);

signals:
    void waitingChanged(bool waits);
    /// Empty: no key.
    void keyPressed(const QKeySequence& key);

protected:
    bool event(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    QString id_;
    QString keys_; ///< as text
    bool waits_ = false;
};

/// Two views of one sheet: an overview, and with "Change keys" all commands with a button for the key of each. It is
/// not modal; Escape closes it. GUI thread.
class ShortcutSheet : public QDialog {
    Q_OBJECT
public:
    /// The registry must outlive the sheet, and `window` becomes its parent.
    ShortcutSheet(CommandRegistry& registry, QWidget* window);

    /// Shows the buttons that change keys, or the overview.
    void setEditing(bool editing);
    /// What the sheet says about the last key; empty: nothing.
    QString message() const { return message_->text(); }

private:
    void rebuild();
    QWidget* overview();
    QWidget* editor();
    void connectButton(KeyButton* button);
    /// Gives the key to the button's command, or says why not; pressed twice, it is taken from its owner.
    void take(KeyButton* button, const QKeySequence& key);
    void say(const QString& text);

    CommandRegistry& registry_;
    bool editing_ = false;
    QKeySequence asked_; ///< the key that is another command's, after its first press
    QScrollArea* scroll_ = new QScrollArea(this);
    QPushButton* change_ = new QPushButton(tr("Change keys"), this);
    QPushButton* reset_ = new QPushButton(tr("Reset all keys"), this);
    QLabel* message_ = new QLabel(this);
};

/// Makes the sheet as a child of `window`.
QDialog* makeShortcutSheet(CommandRegistry& registry, QWidget* window);

} // namespace usar::widgets

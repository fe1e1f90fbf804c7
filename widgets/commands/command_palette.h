// The command palette (Ctrl+K): type a few letters of any command and press Return. With the model of its list.
#pragma once

#include <vector>

#include <QAbstractListModel>
#include <QFrame>
#include <QLineEdit>
#include <QListView>

#include "widgets/commands/command_registry.h"

namespace usar::widgets {

/// Scores how well `typed` matches `text`; higher is better. Every word must occur; matches at the start of a word
/// count more. nullopt: no match. Case is ignored; an empty `typed` matches everything equally.
std::optional<int> matchScore(const QString& typed, const QString& text);

/// Rows are the enabled commands only, by score, then by registration. GUI thread; the registry must outlive the model.
class CommandListModel : public QAbstractListModel {
    Q_OBJECT
public:
    /// ShortcutRole is the shortcut as text, GroupRole the command's group.
    enum Role { ShortcutRole = Qt::UserRole, GroupRole };

    CommandListModel(const CommandRegistry& registry, QObject* parent = nullptr);

    /// Lists the commands that are enabled now and match; call it whenever the palette opens.
    void setFilter(const QString& typed);
    /// Returns nullptr for an invalid index. The registry owns the action.
    QAction* actionAt(const QModelIndex& index) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    const CommandRegistry& registry_;
    std::vector<const CommandRegistry::Command*> rows_;
};

/// A popup over its window, not a dialog: Escape or a click elsewhere closes it. Up and Down choose while the text
/// cursor stays in the line. GUI thread; owned by the window.
class CommandPalette : public QFrame {
    Q_OBJECT
public:
    /// The registry must outlive the palette. The palette is centered over the window, which owns it.
    CommandPalette(const CommandRegistry& registry, QWidget* window);

public slots:
    /// Clears the line, lists the commands that are enabled now, and takes the focus.
    void open();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// Moves the marked row by `by`, stopping at the ends of the list.
    void choose(int by);
    /// Closes the palette and then triggers the marked command, so that the command may open something itself.
    void run();

    CommandListModel* model_;
    QLineEdit* line_ = new QLineEdit(this);
    QListView* list_ = new QListView(this);
};

} // namespace usar::widgets

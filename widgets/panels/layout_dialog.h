// The user's own layouts in a small window beside the others: show, save, rename, delete, import and export.
#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QToolButton>

#include "widgets/style/empty_state.h"

namespace usar::widgets {

/// Tells the user's wishes by signals and changes nothing itself. Not modal; Escape closes it. GUI thread.
class LayoutDialog : public QDialog {
    Q_OBJECT
public:
    explicit LayoutDialog(QWidget* parent);

    /// Lists these layouts; the chosen one stays chosen if it is among them.
    void setNames(const QStringList& names);
    /// Asks for the name of a new layout: the line has the focus and proposes a free name.
    void askForName();
    /// Says what went wrong, below the list; empty: nothing.
    void complain(const QString& text);
    /// The chosen layout; empty: none.
    QString chosen() const;

signals:
    /// The present layout is to be saved under this name, which may be taken: then it replaces the old one.
    void saveRequested(const QString& name);
    void showRequested(const QString& name);
    /// The new name is free and not empty.
    void renameRequested(const QString& from, const QString& to);
    void removeRequested(const QString& name);
    void importRequested();
    void exportRequested(const QString& name);

private:
    QWidget* makeRow();
    /// Begins to edit the name of the chosen layout in the list.
    void editName();
    /// A name was edited in the list.
    void takeName(QListWidgetItem* item);
    /// Enables what can be done.
    void refresh();
    QStringList names() const;

    QListWidget* list_ = new QListWidget(this);
    QLineEdit* name_ = new QLineEdit(this);
    QPushButton* save_ = new QPushButton(tr("Save"), this);
    QLabel* trouble_;
    EmptyState* nothing_ = nullptr; ///< over the list, as long as there is no layout
    QList<QToolButton*> buttons_;   ///< those that need a chosen layout
};

} // namespace usar::widgets

// Sheet that a view shows while it is empty: what will appear here, and a button that makes it appear.
#pragma once

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace usar::widgets {

/// Shows a title, one sentence and, with an action, a button. Covers its parent and follows its size; the mouse reaches
/// the parent except on the button.
class EmptyState : public QWidget {
    Q_OBJECT
public:
    /// `covered` becomes the parent.
    explicit EmptyState(QWidget* covered);

    /// Says what is missing and how to make it appear; both also become the accessible name and description.
    void setText(const QString& title, const QString& hint);
    /// Shows a button that triggers `action` and has its text; nullptr hides it. The action must outlive this sheet.
    void setAction(QAction* action);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QLabel* title_ = new QLabel(this);
    QLabel* hint_ = new QLabel(this);
    QPushButton* button_ = new QPushButton(this);
    QMetaObject::Connection clicked_;
};

} // namespace usar::widgets

// Says that a plan stands still, where and why, and how it goes on.
#pragma once

#include <QBoxLayout>
#include <QFrame>
#include <QLabel>
#include <QToolButton>

namespace usar::widgets {

/// Hidden while there is nothing to say. Buttons are those of commands. GUI thread.
class PlanHaltBar : public QFrame {
    Q_OBJECT
public:
    explicit PlanHaltBar(QWidget* parent = nullptr);

    void setActions(const QList<QAction*>& actions);
    /// A sentence; empty hides the bar.
    void setText(const QString& text);
    QString text() const { return text_->text(); }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void showIcon();

    QBoxLayout* column_;
    QLabel* icon_;
    QLabel* text_;
    QBoxLayout* buttons_;
};

} // namespace usar::widgets

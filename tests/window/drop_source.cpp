// Drops files on a window as a file manager does: drop_source WINDOW X Y URI...
// Speaks the source's side of XDND (version 5) and ends when the window says that it has finished.

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <poll.h>

#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>

namespace {

constexpr int patience_milliseconds = 20'000;

class DropSource {
 public:
  DropSource(Display* display, Window target) : display_(display), target_(target) {
    source_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display_, atom("XdndSelection"), source_, CurrentTime);
  }

  /// Offers a list of URIs at a point of the screen. True when the window took it.
  bool drop(int x, int y, const std::string& uris) {
    uris_ = uris;
    send("XdndEnter", 5L << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
    send("XdndPosition", 0, (static_cast<long>(x) << 16) | y, CurrentTime,
         static_cast<long>(atom("XdndActionCopy")));
    if (!answer_until("XdndStatus")) return false;
    send("XdndDrop", 0, CurrentTime, 0, 0);
    return answer_until("XdndFinished");
  }

 private:
  Atom atom(const char* name) { return XInternAtom(display_, name, False); }

  void send(const char* type, long first, long second, long third, long fourth) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(type);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(source_);
    event.xclient.data.l[1] = first;
    event.xclient.data.l[2] = second;
    event.xclient.data.l[3] = third;
    event.xclient.data.l[4] = fourth;
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XFlush(display_);
  }

  bool answer_until(const char* type) {
    for (;;) {
      while (XPending(display_) == 0) {
        pollfd waiting{ConnectionNumber(display_), POLLIN, 0};
        if (poll(&waiting, 1, patience_milliseconds) <= 0) return false;
      }
      XEvent event;
      XNextEvent(display_, &event);
      if (event.type == SelectionRequest) hand_over(event.xselectionrequest);
      if (event.type == ClientMessage && event.xclient.message_type == atom(type)) return true;
    }
  }

  void hand_over(const XSelectionRequestEvent& request) {
    XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(uris_.data()), static_cast<int>(uris_.size()));
    XEvent reply{};
    reply.xselection.type = SelectionNotify;
    reply.xselection.requestor = request.requestor;
    reply.xselection.selection = request.selection;
    reply.xselection.target = request.target;
    reply.xselection.property = request.property;
    reply.xselection.time = request.time;
    XSendEvent(display_, request.requestor, False, NoEventMask, &reply);
    XFlush(display_);
  }

  Display* display_;
  Window target_, source_ = 0;
  std::string uris_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::cerr << "usage: drop_source WINDOW X Y URI...\n";
    return 2;
  }
  Display* display = XOpenDisplay(nullptr);
  if (!display) {
    std::cerr << "drop_source: no display\n";
    return 1;
  }
  std::string uris;
  for (int i = 4; i < argc; ++i) uris += std::string(argv[i]) + "\r\n";
  DropSource source(display, std::strtoul(argv[1], nullptr, 0));
  const bool taken = source.drop(std::atoi(argv[2]), std::atoi(argv[3]), uris);
  XCloseDisplay(display);
  if (!taken) std::cerr << "drop_source: the window did not take the drop\n";
  return taken ? 0 : 1;
}

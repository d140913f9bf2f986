#include "core/cad/kernel/opencascade/kernel_session.hpp"

#include <IGESControl_Controller.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Controller.hxx>
#include <XCAFApp_Application.hxx>

namespace hariko {

namespace {

std::mutex& kernel_mutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

KernelSession::KernelSession() : lock_(kernel_mutex()) {
  STEPControl_Controller::Init();  // the settings do not exist before
  IGESControl_Controller::Init();
  ::Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
}

KernelDocument::KernelDocument() {
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document_);
}

KernelDocument::~KernelDocument() {
  XCAFApp_Application::GetApplication()->Close(document_);
}

}  // namespace hariko

// SPDX-License-Identifier: BSD-3-Clause
declare module "clipper-lib" {
  const library: object;
  export default library;
}
